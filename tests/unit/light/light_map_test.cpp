// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

Image randomEnvironment(uint32_t width, uint32_t height, uint32_t seed = 1) {
  std::mt19937 random(seed);
  Image image = makeImage(width, height, 3);
  for (float& value : image.pixels) value = std::exponential_distribution<float>()(random);
  return image;
}

TEST(LightMap, KeepsTheEnergyAtAnyRatio) {
  for (const uvec2 source : {uvec2(64, 32), uvec2(37, 19), uvec2(1, 1), uvec2(5, 300)})
    for (const uvec2 target : {uvec2(32, 16), uvec2(100, 50), uvec2(1, 1), uvec2(64, 32), uvec2(7, 11)}) {
      const Image environment = randomEnvironment(source.x, source.y);
      const dvec3 before = totalEnergy(environment), after = totalEnergy(makeLightMap(environment, target));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(after[c] / before[c], 1.0, 1e-6) << source.x << " to " << target.x;
    }
}

TEST(LightMap, SameSizeIsTheSamePicture) {
  const Image environment = randomEnvironment(64, 32);
  const Image map = makeLightMap(environment, {64, 32});
  EXPECT_EQ(map.pixels, environment.pixels);
}

TEST(LightMap, ConstantStaysConstant) {
  Image environment = makeImage(37, 23, 3);
  std::fill(environment.pixels.begin(), environment.pixels.end(), 0.7f);
  for (const float value : makeLightMap(environment, {64, 17}).pixels) EXPECT_FLOAT_EQ(value, 0.7f);
}

TEST(LightMap, TexelsAreSolidAngleMeans) {
  const Image environment = randomEnvironment(6, 4);
  const Image map = makeLightMap(environment, {3, 2});
  auto band = [](double a, double b) { return std::cos(a * kPiDouble) - std::cos(b * kPiDouble); };
  const double top = band(0.5, 0.75) / band(0.5, 1.0);
  for (uint32_t x = 0; x < 3; ++x) {
    double expected = 0.0;
    for (uint32_t i = 0; i < 2; ++i)
      expected +=
          0.5 * (top * environment.at(2 * x + i, 2)[0] + (1.0 - top) * environment.at(2 * x + i, 3)[0]);
    EXPECT_NEAR(map.at(x, 1)[0], expected, 1e-6);
  }
}

TEST(LightMap, OneTexelUpwardsStaysInItsPlace) {
  Image environment = makeImage(4, 2, 3);
  environment.at(3, 1)[1] = 2.0f;
  const Image map = makeLightMap(environment, {12, 4});
  for (uint32_t y = 0; y < 4; ++y)
    for (uint32_t x = 0; x < 12; ++x) EXPECT_FLOAT_EQ(map.at(x, y)[1], x >= 9 && y >= 2 ? 2.0f : 0.0f);
}

TEST(LightMap, SunKeepsItsEnergy) {
  Image environment = randomEnvironment(1000, 500);
  for (int c = 0; c < 3; ++c) environment.at(123, 77)[c] = 1e9f;
  const Image map = makeLightMap(environment, {256, 128});
  EXPECT_NEAR(totalEnergy(map).x / totalEnergy(environment).x, 1.0, 1e-6);
}

}  // namespace
}  // namespace boxlight
