// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_domain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boxlight {
namespace {

vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

TEST(LightDomain, SixAxes) {
  EXPECT_EQ(directionToUv({1, 0, 0}), vec2(0.5f, 0.5f));
  EXPECT_EQ(directionToUv({0, 0, 1}), vec2(0.75f, 0.5f));
  EXPECT_EQ(directionToUv({0, 0, -1}), vec2(0.25f, 0.5f));
  EXPECT_EQ(directionToUv({-1, 0, 0}), vec2(0.0f, 0.5f)) << "the seam counts as u = 0";
  EXPECT_EQ(directionToUv({-1, 0, -0.0f}), vec2(0.0f, 0.5f));
  EXPECT_EQ(directionToUv({0, 1, 0}).y, 0.0f);
  EXPECT_EQ(directionToUv({0, -1, 0}).y, 1.0f);
}

TEST(LightDomain, RoundTrip) {
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    const vec3 d = randomDirection(random);
    const vec2 uv = directionToUv(d);
    EXPECT_TRUE(uv.x >= 0.0f && uv.x < 1.0f && uv.y >= 0.0f && uv.y <= 1.0f);
    EXPECT_LT(glm::length(uvToDirection(uv) - d), 2e-6f);
  }
  const vec3 nearPole = glm::normalize(vec3(1e-4f, 1.0f, 0.0f));
  EXPECT_NEAR(directionToUv(nearPole).y, 1e-4f / kPi, 1e-10f);
}

TEST(LightDomain, RotationIsAnOffsetInU) {
  std::mt19937 random(2);
  for (const float degrees : {0.0f, 30.0f, 90.0f, -45.0f, 180.0f, 725.0f}) {
    const float angle = degrees * kPi / 180.0f, c = std::cos(-angle), s = std::sin(-angle);
    for (int i = 0; i < 100; ++i) {
      const vec3 d = randomDirection(random);
      const vec3 turned(d.x * c + d.z * s, d.y, -d.x * s + d.z * c);  // Ry(-D) d
      const float u = directionToUv(d).x + environmentOffset(degrees), expected = directionToUv(turned).x;
      EXPECT_NEAR(std::remainder(u - expected, 1.0f), 0.0f, 2e-6f) << degrees;
      EXPECT_NEAR(directionToUv(d).y, directionToUv(turned).y, 1e-6f);
    }
  }
}

TEST(LightDomain, OffsetIsInTheUnitInterval) {
  for (const float degrees : {0.0f, -1e-9f, 359.99999f, 360.0f, -360.0f, 1e6f, -90.0f}) {
    EXPECT_GE(environmentOffset(degrees), 0.0f) << degrees;
    EXPECT_LT(environmentOffset(degrees), 1.0f) << degrees;
  }
  EXPECT_FLOAT_EQ(environmentOffset(-90.0f), 0.75f);
}

/// By the midpoint rule in cos(theta) and phi.
dvec3 meanByQuadrature(double u0, double v0, double du, double dv) {
  constexpr int kSteps = 400;
  const double top = std::cos(kPiDouble * v0), bottom = std::cos(kPiDouble * (v0 + dv));
  dvec3 sum(0.0);
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double y = top + (bottom - top) * (i + 0.5) / kSteps, sine = std::sqrt(1 - y * y);
      const double phi = 2 * kPiDouble * (u0 + du * (j + 0.5) / kSteps - 0.5);
      sum += dvec3(sine * std::cos(phi), y, sine * std::sin(phi));
    }
  return sum / double(kSteps * kSteps);
}

TEST(LightDomain, MeanDirections) {
  const double cases[][4] = {{0.4, 0.2, 0.1, 0.3},   {0.9, 0.0, 0.3, 0.2}, {0.0, 0.0, 1.0, 0.5},
                             {0.1, 0.7, 0.6, 0.3},   {0.2, 0.0, 0.5, 1.0}, {0.0, 0.0, 1.0, 1.0},
                             {0.3, 0.5, 1e-4, 1e-4}, {0.3, 0.0, 0.2, 1e-4}};
  for (const auto& [u, v, du, dv] : cases)
    EXPECT_LT(glm::length(meanDirection(u, v, du, dv) - meanByQuadrature(u, v, du, dv)), 3e-5)
        << u << " " << v << " " << du << " " << dv;
  EXPECT_LT(glm::length(meanDirection(0.625, 0.25, 1e-9, 1e-9) - dvec3(uvToDirection({0.625f, 0.25f}))),
            1e-6);
}

TEST(LightDomain, SolidAngles) {
  EXPECT_NEAR(rectangleSolidAngle(1, 0, 1), 4.0 * kPiDouble, 1e-14);
  EXPECT_NEAR(rectangleSolidAngle(0.25, 0, 0.5), kPiDouble / 2.0, 1e-15);
  EXPECT_NEAR(rectangleSolidAngle(0.5, 0.2, 0.3),
              kPiDouble * (std::cos(0.2 * kPiDouble) - std::cos(0.3 * kPiDouble)), 1e-14);
  const double thin = 1e-9, cap = rectangleSolidAngle(1, 0, thin);
  EXPECT_NEAR(cap / (kPiDouble * std::pow(thin * kPiDouble, 2)), 1.0, 1e-12) << "a small cap is a flat disc";
  EXPECT_EQ(rectangleSolidAngle(1, 0.4, 0.4), 0.0);
}

}  // namespace
}  // namespace boxlight
