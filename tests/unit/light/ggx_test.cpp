// SPDX-License-Identifier: Apache-2.0
#include "common/light/ggx.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace boxlight {
namespace {

constexpr float kAlphas[] = {1e-4f, 1e-3f, 0.02f, 0.1f, 0.3f, 0.7f, 1.0f};

vec3 directionAt(float cosine, float phi = 0.0f) {
  const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// Calls visit(h, steradians) for half vectors over the hemisphere whose polar angles crowd where a lobe of
/// width alpha is.
template <class Visit>
void forHalfVectors(double alpha, const Visit& visit) {
  constexpr int kRings = 2000, kSectors = 200;
  for (int i = 0; i < kRings; ++i) {
    // tan(theta) = alpha s / (1 - s): sin(theta) dtheta = tan cos^3 dtan
    const double s = (i + 0.5) / kRings, t = alpha * s / (1.0 - s), z = 1.0 / std::sqrt(1.0 + t * t);
    const double steradians =
        t * z * z * z * alpha / ((1.0 - s) * (1.0 - s)) * 2.0 * kPiDouble / (double(kRings) * kSectors);
    for (int j = 0; j < kSectors; ++j) {
      const double phi = 2.0 * kPiDouble * (j + 0.5) / kSectors;
      visit(vec3(t * z * std::cos(phi), t * z * std::sin(phi), z), steradians);
    }
  }
}

template <class F>
double integrateHalfVectors(double alpha, const F& f) {
  double sum = 0.0;
  forHalfVectors(alpha, [&](vec3 h, double steradians) { sum += steradians * double(f(h)); });
  return sum;
}

TEST(Ggx, ProjectedAreaOfTheMicrofacetsIsOne) {
  for (const float alpha : kAlphas)
    EXPECT_NEAR(integrateHalfVectors(alpha, [&](vec3 h) { return ggx::distribution(h, alpha) * h.z; }), 1.0,
                1e-3)
        << alpha;
}

TEST(Ggx, VisibleNormalDensityIntegratesToOne) {
  for (const float alpha : kAlphas)
    for (const float cosine : {1.0f, 0.6f, 0.1f}) {
      const vec3 view = directionAt(cosine, 0.4f);
      EXPECT_NEAR(
          integrateHalfVectors(alpha, [&](vec3 h) { return ggx::visibleNormalDensity(view, h, alpha); }), 1.0,
          2e-3)
          << alpha << " " << cosine;
    }
}

TEST(Ggx, VisibilityIsHeightCorrelatedSmith) {
  for (const float alpha : kAlphas)
    for (const float nDotV : {0.05f, 0.4f, 1.0f})
      for (const float nDotL : {0.05f, 0.7f, 1.0f}) {
        const float g = 1.0f / (1.0f + ggx::lambda(nDotV, alpha) + ggx::lambda(nDotL, alpha));
        EXPECT_NEAR(ggx::visibility(nDotL, nDotV, alpha) * 4.0f * nDotL * nDotV / g, 1.0f, 1e-4f);
        EXPECT_NEAR(ggx::masking(nDotV, alpha) * (1.0f + ggx::lambda(nDotV, alpha)), 1.0f, 1e-4f);
      }
  const double tangent2 = (1.0 - 0.16) / 0.16;  // Heitz 2014, Equation 72, at cosine .4 and alpha .3
  EXPECT_NEAR(ggx::lambda(0.4f, 0.3f), 0.5 * (std::sqrt(1.0 + 0.09 * tangent2) - 1.0), 1e-6);
}

TEST(Ggx, PeakIsRightAtTinyAlpha) {
  for (const float alpha : kAlphas)
    EXPECT_NEAR(ggx::distribution({0, 0, 1}, alpha) * kPi * alpha * alpha, 1.0f, 1e-5f);
  const float alpha = 1e-3f, t = 2e-3f;  // D = a^2 / (pi cos^4 (a^2 + tan^2)^2)
  const vec3 half = glm::normalize(vec3(t, 0, 1));
  EXPECT_NEAR(ggx::distribution(half, alpha) * kPi * 25.0f * alpha * alpha, 1.0f, 1e-4f);
  EXPECT_EQ(ggx::distribution({0, 0, -1}, 0.5f), 0.0f);
}

TEST(Ggx, SchlickWeight) {
  EXPECT_EQ(ggx::schlickWeight(1.0f), 0.0f);
  EXPECT_EQ(ggx::schlickWeight(0.0f), 1.0f);
  EXPECT_FLOAT_EQ(ggx::schlickWeight(0.5f), 1.0f / 32.0f);
  EXPECT_EQ(ggx::schlickWeight(1.0000001f), 0.0f);
}

/// Share of the samples in 8 sectors and 8 rings of equal density, against the integral of the density there.
TEST(Ggx, SamplesFollowTheDensity) {
  constexpr int kBins = 8, kSamples = 400;  // squared
  for (const float alpha : {0.05f, 0.4f, 1.0f})
    for (const float cosine : {0.15f, 0.8f}) {
      const vec3 view = directionAt(cosine, 1.0f);
      auto binOf = [&](vec3 h) {
        const float t2 = (h.x * h.x + h.y * h.y) / (h.z * h.z * alpha * alpha);
        const float turn = std::atan2(h.y, h.x) / (2.0f * kPi) + 0.5f;
        return std::min(kBins - 1, int(kBins * t2 / (1.0f + t2))) * kBins +
               std::min(kBins - 1, int(kBins * turn));
      };
      std::array<double, kBins * kBins> expected{}, found{};
      forHalfVectors(alpha, [&](vec3 h, double steradians) {
        expected[size_t(binOf(h))] += steradians * double(ggx::visibleNormalDensity(view, h, alpha));
      });
      for (int i = 0; i < kSamples; ++i)
        for (int j = 0; j < kSamples; ++j)
          found[size_t(binOf(ggx::sampleVisibleNormal(
              view, alpha, (vec2(i, j) + 0.5f) / float(kSamples))))] += 1.0 / (double(kSamples) * kSamples);
      for (size_t b = 0; b < expected.size(); ++b)
        EXPECT_NEAR(found[b], expected[b], 0.002) << alpha << " " << cosine << " bin " << b;
    }
}

TEST(Ggx, NoNanAnywhere) {
  for (const float alpha : kAlphas)
    for (const float cosine : {0.0f, 1e-6f, 1e-3f, 0.5f, 0.7f, 0.99999f, 1.0f})
      for (const float u : {0.0f, 0.25f, 0.5f, 0.75f, 0.99999994f})
        for (const float w : {0.0f, 0.3f, 0.999f, 0.99999994f}) {
          const vec3 view = directionAt(cosine), half = ggx::sampleVisibleNormal(view, alpha, {u, w});
          EXPECT_NEAR(glm::length(half), 1.0f, 1e-5f) << alpha << " " << cosine << " " << u << " " << w;
          EXPECT_GE(half.z, 0.0f);
          EXPECT_TRUE(std::isfinite(ggx::visibleNormalDensity(view, half, alpha)));
        }
}

}  // namespace
}  // namespace boxlight
