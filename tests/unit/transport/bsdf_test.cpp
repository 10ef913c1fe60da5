// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bake/transport/sampler.h"
#include "tests/support/bsdf_lab.h"

using namespace boxlight;

namespace {

MaterialSample makeMaterial(float metallic, float roughness, float specular = 1) {
  MaterialSample m;
  m.baseColor = {0.9f, 0.5f, 0.2f};
  m.metallic = metallic;
  m.roughness = roughness;
  m.specular = specular;
  return m;
}

vec3 direction(float cosine, float phi = 0.7f) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

const std::vector<MaterialSample>& materials() {
  static const std::vector<MaterialSample> list = {
      makeMaterial(0, 1, 0), makeMaterial(0, 0.5f), makeMaterial(0, 0.15f),   makeMaterial(1, 0.1f),
      makeMaterial(1, 0.3f), makeMaterial(1, 1),    makeMaterial(0.5f, 0.4f), makeMaterial(0, 0.4f, 0.3f)};
  return list;
}

}  // namespace

// Pearson's chi-square of sampled directions against the density, both over a grid of (cos theta, phi) cells.
TEST(Bsdf, SamplingFollowsTheDensity) {
  constexpr int kCos = 24, kPhi = 48, kSub = 8, kSamples = 200000;
  for (size_t m = 0; m < materials().size(); ++m)
    for (float cosine : {0.95f, 0.5f, 0.15f}) {
      if (materials()[m].roughness < 0.2f) continue;  // a lobe narrower than a cell: GlossyWeights covers it
      const Bsdf bsdf(materials()[m], direction(cosine));
      std::vector<double> expected(kCos * kPhi, 0), observed(kCos * kPhi, 0);
      for (int i = 0; i < kCos * kSub; ++i)
        for (int j = 0; j < kPhi * kSub; ++j) {
          const vec3 wi = direction((float(i) + 0.5f) / float(kCos * kSub),
                                    2 * kPi * (float(j) + 0.5f) / float(kPhi * kSub));
          expected[size_t(i / kSub * kPhi + j / kSub)] +=
              bsdf.evaluate(wi).density * 2 * kPiDouble / (kCos * kSub * kPhi * kSub) * kSamples;
        }
      for (uint32_t s = 0; s < kSamples; ++s) {
        Sampler sampler({17, uint32_t(m), 0}, s);
        const float choice = sampler.next();
        const vec3 wi = bsdf.sample(choice, {sampler.next(), sampler.next()}).wi;
        if (wi.z <= 0) continue;
        float phi = std::atan2(wi.y, wi.x) / (2 * kPi);
        if (phi < 0) phi += 1;
        observed[size_t(std::min(int(wi.z * kCos), kCos - 1) * kPhi + std::min(int(phi * kPhi), kPhi - 1))] +=
            1;
      }
      double chi2 = 0;
      int degrees = 0;
      for (size_t c = 0; c < expected.size(); ++c) {
        if (expected[c] < 20) continue;
        chi2 += (observed[c] - expected[c]) * (observed[c] - expected[c]) / expected[c];
        ++degrees;
      }
      // Wilson-Hilferty: (chi2/n)^(1/3) is nearly normal. The slack of .1 is the quadrature's own error.
      const double z =
          (std::cbrt(chi2 / degrees) - (1 - 2.0 / (9 * degrees))) / std::sqrt(2.0 / (9 * degrees));
      EXPECT_LT(chi2 / degrees, 1.1 + 5.0 / std::sqrt(double(degrees)))
          << "material " << m << ", cosine " << cosine << ", z " << z;
      EXPECT_GT(degrees, 20);
    }
}

TEST(Bsdf, IsReciprocal) {
  for (const MaterialSample& m : materials()) {
    const vec3 a = direction(0.8f, 0.2f), b = direction(0.3f, 2.9f);
    const Rgb forward = Bsdf(m, a).evaluate(b).value / b.z, backward = Bsdf(m, b).evaluate(a).value / a.z;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(forward[c], backward[c], 1e-5f * std::max(1.0f, forward[c]));
  }
}

TEST(Bsdf, AlbedoTableMatchesQuadratureAndStaysBelowOne) {
  for (const MaterialSample& m : materials()) {
    for (float cosine : {0.05f, 0.3f, 0.7f, 1.0f}) {
      const Bsdf bsdf(m, direction(cosine));
      const Rgb quadrature = test::sampledAlbedo(bsdf, kSpecular, 256), table = bsdf.viewDependentAlbedo();
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(table[c], quadrature[c], 3e-3f) << "roughness " << m.roughness << ", cosine " << cosine;
        EXPECT_LE(quadrature[c], 1.0001f);
      }
    }
  }
}

TEST(Bsdf, NothingBelowTheHorizonAndNothingInfinite) {
  for (float roughness : {0.0f, 0.01f, 0.1f, 1.0f})
    for (float cosine : {1e-3f, 0.5f, 1.0f}) {
      const Bsdf bsdf(makeMaterial(1, roughness), direction(cosine));
      EXPECT_EQ(bsdf.evaluate(direction(0.5f) * vec3(1, 1, -1)).value, Rgb(0));
      for (float u : {0.0f, 0.5f, 0.999999f}) {
        const vec3 wi = bsdf.sample(0, {u, 0.999999f - u}).wi;
        const LobeValue lobe = bsdf.evaluate(wi);
        for (int c = 0; c < 3; ++c) {
          EXPECT_TRUE(std::isfinite(wi[c]) && std::isfinite(lobe.value[c]) && std::isfinite(lobe.density));
          EXPECT_LE(lobe.value[c], 1.0001f * lobe.density);
        }
      }
    }
}

TEST(Bsdf, SpecularZeroIsPureLambert) {
  const Bsdf bsdf(makeMaterial(0, 0.3f, 0), direction(0.2f));
  EXPECT_FALSE(bsdf.has(kViewDependent));
  EXPECT_NEAR(bsdf.evaluate(direction(0.7f)).value.x, 0.9f * 0.7f / kPi, 1e-6f);
}

// A coat whose normal leans away from the surface's reflects into the surface what its albedo counts all the
// same.
TEST(Bsdf, WhatACoatReflectsIntoTheSurfaceIsTold) {
  MaterialSample m = makeMaterial(0, 0.5f, 0);
  m.baseColor = Rgb(0);
  m.clearcoat = 1;
  m.clearcoatRoughness = 0.5f;
  const Bsdf bsdf(m, direction(0.2f, 0), {}, glm::normalize(vec3(-0.4f, 0, 1)));
  double kept = 0, lost = 0;
  constexpr uint32_t kSamples = 1u << 16;
  for (uint32_t s = 0; s < kSamples; ++s) {
    Sampler sampler({18, 0, 0}, s);
    const LobeSample drawn = bsdf.sample(0, sampler.next2(), kViewDependent);
    lost += double(drawn.lost.x) / kSamples;
    if (drawn.wi == vec3(0.0f)) continue;
    const LobeValue value = bsdf.evaluate(drawn.wi, kViewDependent);
    kept += double(value.value.x / value.density) / kSamples;
  }
  EXPECT_GT(lost, 0.1 * kept);
  EXPECT_NEAR((kept + lost) / double(bsdf.viewDependentAlbedo().x), 1, 5e-3);
}
