// SPDX-License-Identifier: Apache-2.0
#include "common/light/thin_film.h"

#include <cmath>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

float square(float x) { return x * x; }

float normalReflectance(float ior, float outerIor) { return square((ior - outerIor) / (ior + outerIor)); }

float schlick(float f0, float cosine) { return glm::mix(f0, 1.0f, ggx::schlickWeight(cosine)); }

/// Fourier transform of the colour matching functions at an optical path difference in metres, phase shifted:
/// Gaussians in frequency, the paper's supplemental code; in linear Rec. 709.
Rgb sensitivity(float pathDifference, Rgb shift) {
  const float phase = 2.0f * kPi * pathDifference;
  const auto lobe = [&](float height, float position, float variance, float s) {
    return height * std::sqrt(2.0f * kPi * variance) * std::cos(position * phase + s) *
           std::exp(-phase * phase * variance);
  };
  constexpr float kNormalisation = 1.0685e-7f;
  const float x =
      lobe(5.4856e-13f, 1.6810e6f, 4.3278e9f, shift.x) + lobe(9.7470e-14f, 2.2399e6f, 4.5282e9f, shift.x);
  const float y = lobe(4.4201e-13f, 1.7953e6f, 9.3046e9f, shift.y);
  const float z = lobe(5.2481e-13f, 2.2084e6f, 6.6121e9f, shift.z);
  const vec3 xyz = vec3(x, y, z) / kNormalisation;
  return {3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
          -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
          0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z};
}

}  // namespace

Rgb thinFilmReflectance(float cosine, float filmIor, float thickness, Rgb baseF0) {
  const float ior = glm::mix(1.0f, filmIor, glm::smoothstep(0.0f, 30.0f, thickness));
  const float sine2 = (1.0f - cosine * cosine) / (ior * ior);
  const float inside = std::sqrt(std::max(0.0f, 1.0f - sine2));  // cosine in the film, at least that outside
  const float outer = schlick(normalReflectance(ior, 1.0f), cosine), passed = 1.0f - outer;
  Rgb base(0.0f),
      shift(0.0f);  // reflectance of the film's lower boundary; the phase that both reflections add
  for (int c = 0; c < 3; ++c) {
    const float root = std::sqrt(std::clamp(baseF0[c], 0.0f, 0.9999f)),
                baseIor = (1.0f + root) / (1.0f - root);
    base[c] = schlick(normalReflectance(baseIor, ior), inside);
    shift[c] = kPi + (baseIor < ior ? kPi : 0.0f);
  }
  const float pathDifference = 2e-9f * ior * thickness * inside;
  Rgb sum(0.0f);
  for (int c = 0; c < 3; ++c)
    sum[c] = outer + square(passed) * base[c] / (1.0f - std::min(outer * base[c], 0.9999f));
  Rgb order = sum - Rgb(outer) - Rgb(passed);
  for (int m = 1; m <= 2; ++m) {
    order *= glm::sqrt(outer * base);
    sum += order * 2.0f * sensitivity(float(m) * pathDifference, float(m) * shift);
  }
  return glm::clamp(sum, 0.0f, 1.0f);
}

Rgb schlickF0(Rgb reflectance, float cosine) {
  const float weight = std::min(ggx::schlickWeight(cosine), 0.9999f);
  return glm::clamp((reflectance - weight) / (1.0f - weight), 0.0f, 1.0f);
}

}  // namespace boxlight
