// SPDX-License-Identifier: Apache-2.0
#include "common/light/film_lobe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"
#include "common/light/lobe_clip.h"
#include "common/light/thin_film.h"

namespace boxlight {
namespace {

struct Coating {
  float ior, thickness;
  Rgb baseF0;
  Rgb operator()(float cosine) const { return thinFilmReflectance(cosine, ior, thickness, baseF0); }
};
const Coating kCoatings[] = {{1.8f, 480, Rgb(0.35f)}, {1.3f, 400, Rgb(0.04f)}, {1.4f, 550, {1, 0.7f, 0.3f}}};

GgxLobe lobeAt(float cosine, float roughness, float turn) {
  GgxLobe lobe;
  lobe.view = {std::sqrt(1 - cosine * cosine) * std::cos(turn), cosine,
               std::sqrt(1 - cosine * cosine) * std::sin(turn)};
  lobe.alpha = vec2(roughness * roughness);
  return lobe;
}

/// What the film reflects of a white light, by visible normals.
dvec3 exact(const Coating& film, float cosine, float roughness) {
  constexpr int kSide = 48;
  const vec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
  const vec2 alpha(roughness * roughness);
  dvec3 sum(0);
  for (int i = 0; i < kSide * kSide; ++i) {
    const vec2 random = (vec2(float(i % kSide), float(int(i / kSide))) + 0.5f) / float(kSide);
    const vec3 half = ggx::sampleVisibleNormal(view, alpha, random);
    const vec3 light = 2 * glm::dot(view, half) * half - view;
    if (!(light.z > 0)) continue;
    const float weight =
        ggx::visibility(light, view, alpha) * 4 * light.z * view.z / ggx::masking(view, alpha);
    sum += dvec3(weight * film(glm::dot(view, half)));
  }
  return sum / double(kSide * kSide);
}

TEST(FilmLobe, ReflectsWhatTheFilmDoesOverAllHalfVectors) {
  for (const Coating& film : kCoatings)
    for (const float roughness : {0.1f, 0.25f, 0.4f, 0.6f}) {
      double squares = 0;
      int count = 0;
      for (const float cosine : {0.02f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.75f, 0.9f, 1.0f}) {
        GgxLobe lobe = lobeAt(cosine, roughness, 0.7f);
        fitFresnel(lobe, film);
        const Rgb albedo = filmedAlbedo(lobe, albedoTable().specular(roughness, cosine));
        const dvec3 error = dvec3(albedo) - exact(film, cosine, roughness);
        squares += glm::dot(error, error) / 3, ++count;
        EXPECT_LT(glm::length(error), 0.09) << film.thickness << ' ' << roughness << ' ' << cosine;
      }
      EXPECT_LT(std::sqrt(squares / count), 0.025) << film.thickness << ' ' << roughness;
    }
}

TEST(FilmLobe, OfASharpLobeTheFactorIsThatOfTheView) {
  for (const Coating& film : kCoatings)
    for (const float cosine : {0.1f, 0.4f, 0.8f, 1.0f}) {
      GgxLobe lobe = lobeAt(cosine, 0.01f, 2);
      fitFresnel(lobe, film);
      const Rgb there = lobe.f0 + (lobe.f90 - lobe.f0) * ggx::schlickWeight(cosine);
      EXPECT_LT(glm::length(there - film(cosine)), 5e-3f) << film.thickness << ' ' << cosine;
    }
}

TEST(FilmLobe, BoxesOfBlackFilmsHaveEnergyInEveryChannel) {
  GgxLobe lobe = lobeAt(0.4f, 0.3f, 0);
  fitFresnel(lobe, [](float) { return Rgb(0, 0.5f, 0); });
  dvec3 sum(0);
  for (const Box& box : lobeBoxes(lobe)) sum += dvec3(box.energy);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1, 1e-5);
}

TEST(FilmLobe, AConstantLightIsTheFilmsColourWhateverIsHidden) {
  const dvec3 quotient(0.02, 1.1, 0.9);  // of the film and of what kernels are divided by
  const double own = double(luminance(Rgb(quotient)));
  for (const double hidden : {0.0, 1e-6, 0.3, 0.999})
    for (const double part : {0.0, 1e-6, 0.3, 1.0}) {
      const dvec3 found = splitRadiance((1 - hidden) * quotient, hidden, part * quotient, part * own, own);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], quotient[c], 1e-9) << hidden << ' ' << part;
    }
}

}  // namespace
}  // namespace boxlight
