// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/environment_sampler.h"

#include <gtest/gtest.h>

#include "bake/transport/sampler.h"
#include "common/light/light_domain.h"

using namespace boxlight;

namespace {

Image makeEnvironment(uint32_t width, uint32_t height, float sky) {
  Image image = makeImage(width, height, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), sky);
  return image;
}

}  // namespace

TEST(EnvironmentSampler, DensityIntegratesToOne) {
  Image image = makeEnvironment(32, 16, 0.1f);
  image.at(5, 3)[0] = 1e5f;
  const EnvironmentSampler sampler(image, 40);
  double total = 0;
  constexpr int kU = 512, kV = 256;
  for (int y = 0; y < kV; ++y)
    for (int x = 0; x < kU; ++x) {
      const vec2 uv((float(x) + 0.5f) / kU, (float(y) + 0.5f) / kV);
      total += double(sampler.density(uvToDirection(uv))) *
               rectangleSolidAngle(1.0 / kU, double(y) / kV, double(y + 1) / kV);
    }
  EXPECT_NEAR(total, 1, 1e-4);
}

TEST(EnvironmentSampler, SampledDirectionsHaveTheDensityTheyClaim) {
  Image image = makeEnvironment(16, 8, 0.5f);
  image.at(15, 0)[1] = 50;
  image.at(3, 7)[2] = 20;
  for (float rotation : {0.0f, 75.0f}) {
    const EnvironmentSampler sampler(image, rotation);
    for (uint32_t i = 0; i < 2000; ++i) {
      Sampler random({1, 1, 1}, i);
      const auto sample = sampler.sample(random.next2());
      ASSERT_NEAR(glm::length(sample.direction), 1, 1e-5);
      ASSERT_GT(sample.density, 0);
      ASSERT_NEAR(sampler.density(sample.direction) / sample.density, 1, 0.7)
          << i;  // at a texel's border rounding may change texel
    }
  }
}

TEST(EnvironmentSampler, EstimatesTheIntegralOfASun) {
  Image image = makeEnvironment(64, 32, 0.01f);
  for (int c = 0; c < 3; ++c) image.at(40, 9)[c] = 1e6f;
  const EnvironmentSampler sampler(image, 0);
  double estimate = 0;
  constexpr uint32_t kSamples = 65536;
  for (uint32_t i = 0; i < kSamples; ++i) {
    Sampler random({1, 2, 3}, i);
    const auto s = sampler.sample(random.next2());
    estimate += double(s.radiance.x) / s.density / kSamples;
  }
  // Bilinear interpolation spreads the texel over its neighbours by 1-6-1 filters: sum over rows of weight
  // times solid angle.
  double expected = 0.01 * 4 * kPiDouble;
  for (int row = -1; row <= 1; ++row)
    expected +=
        1e6 * (row ? 0.125 : 0.75) * rectangleSolidAngle(1.0 / 64, (9.0 + row) / 32, (10.0 + row) / 32);
  EXPECT_NEAR(estimate / expected, 1, 5e-3);
}

TEST(EnvironmentSampler, RotationTurnsCounterClockwiseSeenFromAbove) {
  Image image = makeEnvironment(4, 2, 0);
  for (uint32_t y = 0; y < 2; ++y) image.at(2, y)[0] = 1;  // lit around +X, towards +Z (u in [.5, .75])
  const vec3 lit = uvToDirection({0.625f, 0.5f});
  EXPECT_GT(EnvironmentSampler(image, 0).radiance(lit).x, 0.9f);
  // Ry(90) turns +X into -Z: the light follows.
  EXPECT_GT(EnvironmentSampler(image, 90).radiance({lit.z, 0, -lit.x}).x, 0.9f);
  EXPECT_LT(EnvironmentSampler(image, 90).radiance({-lit.z, 0, lit.x}).x, 0.1f);
}

TEST(EnvironmentSampler, BlackHasDensityZero) {
  const Image image = makeEnvironment(8, 4, 0);
  const EnvironmentSampler sampler(image, 0);
  EXPECT_EQ(sampler.sample({0.3f, 0.6f}).density, 0);
  EXPECT_EQ(sampler.density({0, 1, 0}), 0);
}
