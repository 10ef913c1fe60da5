// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "common/light/summed_area.h"

namespace boxlight {
namespace {

constexpr double kSun = 1e6;

Image constantMap(uvec2 size) {
  Image map = makeImage(size.x, size.y, 3);
  for (size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = float(1 + i % 3);
  return map;
}

Image noisyMap(uvec2 size) {
  Image map = makeImage(size.x, size.y, 3);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (float& value : map.pixels) value = uniform(random);
  return map;
}

std::vector<dvec3> normals() {
  std::vector<dvec3> list = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 200; ++i)
    list.push_back(glm::normalize(dvec3(gauss(random), gauss(random), gauss(random))));
  return list;
}

dvec3 irradiance(const Image& map, dvec3 normal) {
  const auto angles = texelSolidAngles(map.width, map.height);
  dvec3 sum(0.0);
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x) {
      const dvec3 direction(uvToDirection((vec2(x, y) + 0.5f) / vec2(map.width, map.height)));
      sum += std::max(glm::dot(normal, direction), 0.0) * angles[y] * dvec3(rgbAt(map, x, y));
    }
  return sum;
}

TEST(LightMoments, OfAConstantLightAreThoseOfTheRectangle) {
  for (const uvec2 size : {uvec2(1, 1), uvec2(67, 33), uvec2(512, 256)}) {
    const LightMoments moments(constantMap(size));
    for (const double offset : {0.0, 0.3141})
      for (const Rectangle& r : {Rectangle{0.2, 0.25, 0.3, 0.5}, Rectangle{0.9, 0, 0.7, 0.125},
                                 Rectangle{0.123, 0.5, 1, 0.5}, Rectangle{0.77, 0.625, 0.001, 0.0078125}}) {
        const dmat3 found = moments.integrate(r, offset);
        const dvec3 expected = r.solidAngle() * meanDirection(r.u0, r.v0, r.du, r.dv);
        for (int c = 0; c < 3; ++c)
          EXPECT_LT(glm::length(found[c] - (c + 1.0) * expected),
                    (r.du < 0.01 ? 3e-5 : 1e-6) * (c + 1) * r.solidAngle())
              << size.x << " from " << r.u0 << " channel " << c;
      }
  }
}

TEST(LightMoments, RoundToTheirRaster) {
  const LightMoments moments(constantMap({8, 4}));
  const dmat3 off = moments.integrate({0, 0.2501, 1, 0.2499}), on = moments.integrate({0, 0.25, 1, 0.25});
  EXPECT_EQ(off, on);
}

TEST(LightMoments, AConstantLightGivesEveryHemisphereTheSame) {
  const LightMoments moments(constantMap({512, 256}));
  for (const dvec3 n : normals()) {
    const auto [found, moment] = moments.hemisphere(n, 0.271);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(found[c], kPiDouble * (c + 1), 2e-6 * (c + 1));
      EXPECT_LT(glm::length(moment[c] - glm::dot(moment[c], n) * n), 0.03 * kPiDouble * (c + 1)) << c;
    }
  }
}

TEST(LightMoments, HemispheresOfNoise) {
  const Image map = noisyMap({128, 64});
  const LightMoments moments(map);
  for (const dvec3 n : normals()) {
    const dvec3 expected = irradiance(map, n), found = moments.hemisphere(n).irradiance;
    EXPECT_LT(glm::length(found - expected), 2e-3 * glm::length(expected));
  }
}

/// Lambert's law, up to the terminator.
TEST(LightMoments, HemispheresOfASun) {
  Image map = makeImage(512, 256, 3);
  map.at(391, 81)[1] = float(kSun);
  const LightMoments moments(map);
  const dvec3 sun(uvToDirection({391.5f / 512, 81.5f / 256}));
  const double strength = kSun * texelSolidAngles(512, 256)[81];
  for (const dvec3 n : normals()) {
    const double error = moments.hemisphere(n).irradiance.y / strength - std::max(glm::dot(n, sun), 0.0);
    EXPECT_LT(std::abs(error), 1e-4) << "at cosine " << glm::dot(n, sun);
    EXPECT_EQ(moments.hemisphere(n).irradiance.x, 0.0);
  }
}

/// A lamp of more texels than are told apart is blurred around its terminator.
TEST(LightMoments, HemispheresOfALamp) {
  Image map = makeImage(256, 128, 3);
  for (uint32_t y = 40; y < 47; ++y)
    for (uint32_t x = 200; x < 207; ++x) map.at(x, y)[1] = float(kSun);
  const LightMoments moments(map);
  double most = 0;
  for (const dvec3 n : normals()) {
    const double expected = irradiance(map, n).y;
    most = std::max(most, expected);
    EXPECT_LT(std::abs(moments.hemisphere(n).irradiance.y - expected), 0.02 * most);
  }
}

TEST(LightMoments, TurnWithTheLight) {
  const Image map = noisyMap({256, 128});
  Image turned = map;
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x)
      std::copy_n(map.at((x + 64) % 256, y), 3, turned.at(x, y));  // by a quarter
  const LightMoments moments(map), other(turned);
  const Rectangle r{0.3, 0.25, 0.4, 0.375};
  const dmat3 a = moments.integrate(r, 0.25), b = other.integrate(r);
  for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(a[c] - b[c]), 1e-6);
  const dvec3 n = glm::normalize(dvec3(0.3, -0.4, 0.7));
  EXPECT_LT(glm::length(moments.hemisphere(n, 0.25).irradiance - other.hemisphere(n).irradiance), 1e-6);
  EXPECT_LT(glm::length(moments.hemisphere(n, 0.25).moment[0] - other.hemisphere(n).moment[0]), 1e-5);
}

}  // namespace
}  // namespace boxlight
