// SPDX-License-Identifier: Apache-2.0
#include "common/light/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

float schlick(float f0, float cosine) { return glm::mix(f0, 1.0f, ggx::schlickWeight(cosine)); }

double lobe(double nanometres, double mean, double below, double above) {
  const double t = (nanometres - mean) * (nanometres < mean ? below : above);
  return std::exp(-0.5 * t * t);
}

/// CIE 1931 colour matching functions: Wyman, Sloan, Shirley, "Simple Analytic Approximations to the CIE XYZ
/// Color Matching Functions", JCGT 2(2), 2013, multi-lobe fit.
dvec3 colourMatching(double nm) {
  return {1.056 * lobe(nm, 599.8, 0.0264, 0.0323) + 0.362 * lobe(nm, 442.0, 0.0624, 0.0374) -
              0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
          0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
          1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

/// Airy's formula wavelength by wavelength, a grey base, into linear Rec. 709: an answer that shares no
/// approximation with the series but Schlick's terms at the boundaries.
Rgb spectral(float cosine, float ior, float thickness, float baseF0) {
  const double inside = std::sqrt(1 - (1 - double(cosine) * cosine) / (double(ior) * ior));
  const double root = std::sqrt(double(baseF0)), baseIor = (1 + root) / (1 - root);
  auto normal = [](double a, double b) { return (a - b) * (a - b) / ((a + b) * (a + b)); };
  const double outer = double(schlick(float(normal(ior, 1)), cosine)),
               base = double(schlick(float(normal(baseIor, ior)), float(inside)));
  const double r12 = -std::sqrt(outer), r23 = (baseIor > ior ? -1 : 1) * std::sqrt(base);
  dvec3 sum(0), white(0);
  for (double nm = 360; nm < 830; nm += 0.25) {
    const std::complex<double> turn = std::polar(1.0, 4 * kPiDouble * ior * thickness * inside / nm);
    const double reflectance = std::norm((r12 + r23 * turn) / (1.0 + r12 * r23 * turn));
    sum += reflectance * colourMatching(nm);
    white += colourMatching(nm);
  }
  const dvec3 xyz = sum / white;
  const double mean = outer + (1 - outer) * (1 - outer) * base / (1 - outer * base);  // without interference
  const dvec3 d = xyz - dvec3(mean);
  const dvec3 rgb(3.2404542 * d.x - 1.5371385 * d.y - 0.4985314 * d.z,
                  -0.9692660 * d.x + 1.8760108 * d.y + 0.0415560 * d.z,
                  0.0556434 * d.x - 0.2040259 * d.y + 1.0572252 * d.z);
  return Rgb(glm::clamp(rgb + dvec3(mean), 0.0, 1.0));
}

TEST(ThinFilm, NoFilmIsNoChangeAtNormalIncidence) {
  for (const float f0 : {0.0f, 0.04f, 0.5f, 0.9f})
    EXPECT_NEAR(thinFilmReflectance(1.0f, 1.5f, 0.0f, Rgb(f0)).y, f0, 1e-4f);
}

TEST(ThinFilm, FollowsTheSpectralIntegral) {
  for (const float cosine : {0.3f, 0.7f, 1.0f})
    for (const float thickness : {100.0f, 250.0f, 400.0f, 700.0f})
      for (const float f0 : {0.04f, 0.5f})
        for (const float ior : {1.33f, 1.8f}) {
          if (f0 > 0.1f && ior > 1.33f) continue;  // of .04, above and below the base's index
          const Rgb series = thinFilmReflectance(cosine, ior, thickness, Rgb(f0)),
                    exact = spectral(cosine, ior, thickness, f0);
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(series[c], exact[c],
                        f0 > 0.1f ? 0.04f : 0.012f)  // higher orders weigh more on bright bases
                << "cosine " << cosine << ", " << thickness << " nm, F0 " << f0 << ", index " << ior
                << ", channel " << c;
        }
}

TEST(ThinFilm, IsAReflectanceEverywhere) {
  for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.05f)
    for (const float ior : {1.0f, 1.3f, 2.0f, 3.0f})
      for (const float thickness : {0.0f, 1.0f, 30.0f, 333.0f, 1200.0f, 1e5f})
        for (const float f0 : {0.0f, 0.04f, 1.0f}) {
          const Rgb f = thinFilmReflectance(cosine, ior, thickness, Rgb(f0));
          for (int c = 0; c < 3; ++c) EXPECT_TRUE(f[c] >= 0.0f && f[c] <= 1.0f);
        }
}

TEST(ThinFilm, SchlickF0IsTheInverse) {
  for (const float cosine : {0.05f, 0.4f, 1.0f})
    EXPECT_NEAR(schlickF0(Rgb(schlick(0.3f, cosine)), cosine).x, 0.3f, 2e-3f);
}

}  // namespace
}  // namespace boxlight
