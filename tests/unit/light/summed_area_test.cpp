// SPDX-License-Identifier: Apache-2.0
#include "common/light/summed_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

Image constantMap(uint32_t width, uint32_t height, float value) {
  Image image = makeImage(width, height, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

Image randomMap(uint32_t width, uint32_t height) {
  std::mt19937 random(5);
  Image image = makeImage(width, height, 3);
  for (float& value : image.pixels) value = std::exponential_distribution<float>()(random);
  return image;
}

Rectangle randomRectangle(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  auto size = [&] { return std::pow(2.0, -16.0 * uniform(random)); };
  Rectangle r{uniform(random), 0.0, size(), size()};
  r.v0 = (1.0 - r.dv) * uniform(random);
  if (random() % 4 == 0) r.v0 = 0.0;
  if (random() % 4 == 0) r.v0 = 1.0 - r.dv;
  if (random() % 5 == 0) r.du = 1.0;
  return r;
}

/// Overlap of [a0, a1] and [b0, b1].
double overlap(double a0, double a1, double b0, double b1) {
  return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
}

/// Sum over all texels and turns, without a table.
dvec3 bruteForce(const Image& map, const Rectangle& r, double uOffset) {
  dvec3 sum(0.0);
  for (uint32_t y = 0; y < map.height; ++y) {
    const double v0 = std::max(r.v0, double(y) / map.height),
                 v1 = std::min(r.v0 + r.dv, double(y + 1) / map.height);
    if (v1 <= v0) continue;
    for (uint32_t x = 0; x < map.width; ++x) {
      double du = 0.0;
      for (int turn = -2; turn <= 2; ++turn)
        du += overlap(r.u0 + uOffset, r.u0 + uOffset + r.du, double(x) / map.width + turn,
                      double(x + 1) / map.width + turn);
      sum += rectangleSolidAngle(du, v0, v1) * dvec3(rgbAt(map, x, y));
    }
  }
  return sum;
}

TEST(SummedArea, ConstantMapGivesTheSolidAngle) {
  std::mt19937 random(1);
  for (const uvec2 size : {uvec2(512, 256), uvec2(7, 5), uvec2(1, 1)}) {
    const SummedArea table(constantMap(size.x, size.y, 1.0f));
    EXPECT_NEAR(table.integrate(Rectangle{0, 0, 1, 1}).x, 4.0 * kPiDouble, 1e-13);
    for (int i = 0; i < 2000; ++i) {
      const Rectangle r = randomRectangle(random);
      EXPECT_NEAR(table.integrate(r, 0.37).y / r.solidAngle(), 1.0, 1e-8)
          << r.u0 << " " << r.v0 << " " << r.du << " " << r.dv;
    }
  }
}

TEST(SummedArea, SubTexelPolarCap) {
  const SummedArea table(constantMap(64, 32, 1.0f));
  for (const double dv : {0.5 / 32, 1.5 / 32, 1.0 / 65536}) {
    const Rectangle north{0.2, 0.0, 1.0, dv}, south{0.2, 1.0 - dv, 1.0, dv};
    EXPECT_NEAR(table.integrate(north).x / north.solidAngle(), 1.0, 1e-10);
    EXPECT_NEAR(table.integrate(south).x / south.solidAngle(), 1.0, 1e-8);
  }
}

TEST(SummedArea, AgreesWithBruteForce) {
  const Image map = randomMap(24, 12);
  const SummedArea table(map);
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const Rectangle r = randomRectangle(random);
    const double offset = i % 3 ? std::uniform_real_distribution<double>(-1.0, 1.0)(random) : 0.0;
    const dvec3 fast = table.integrate(r, offset), slow = bruteForce(map, r, offset);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fast[c] / slow[c], 1.0, 1e-8);
  }
}

TEST(SummedArea, OneLitTexel) {
  Image map = makeImage(8, 4, 3);
  map.at(7, 2)[0] = 3.0f;
  const SummedArea table(map);
  const double omega = rectangleSolidAngle(1.0 / 8, 2.0 / 4, 3.0 / 4);
  EXPECT_NEAR(table.integrate(Rectangle{0.5, 0.25, 0.75, 0.75}).x, 3.0 * omega, 1e-14) << "wraps";
  EXPECT_NEAR(table.integrate(Rectangle{7.0 / 8, 0.5, 1.0 / 16, 0.25}).x, 1.5 * omega, 1e-14) << "left half";
  EXPECT_NEAR(table.integrate(Rectangle{0.0, 0.0, 7.0 / 8, 1.0}).x, 0.0, 1e-14);
  EXPECT_NEAR(table.integrate(Rectangle{0.0, 0.0, 1.0 / 8, 1.0}, 7.0 / 8).x, 3.0 * omega, 1e-14) << "rotated";
  EXPECT_EQ(table.integrate(Rectangle{0.0, 0.0, 1.0, 1.0}).y, 0.0);
}

TEST(SummedArea, DarkTexelsBesideASun) {
  Image map = randomMap(512, 256);
  for (int c = 0; c < 3; ++c) map.at(300, 60)[c] = 1e9f;
  const SummedArea table(map);
  std::mt19937 random(3);
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    const uint32_t x = 301 + uint32_t(random() % 200), y = 61 + uint32_t(random() % 190);
    const Rectangle texel{x / 512.0, y / 256.0, 1.0 / 512, 1.0 / 256};
    const double expected = texel.solidAngle() * double(map.at(x, y)[0]);
    if (map.at(x, y)[0] > 0.05f) worst = std::max(worst, std::abs(table.integrate(texel).x / expected - 1.0));
  }
  EXPECT_LT(worst, 1e-4);
}

}  // namespace
}  // namespace boxlight
