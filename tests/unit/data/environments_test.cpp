// SPDX-License-Identifier: Apache-2.0
#include "data/environments.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"
#include "common/light/light_domain.h"

namespace boxlight::data {
namespace {

double texelSolidAngle(const Image& image, uint32_t y) {
  return rectangleSolidAngle(1.0 / image.width, double(y) / image.height, (y + 1.0) / image.height);
}

Rgb lookUp(const Image& image, vec3 direction) {
  const vec2 uv = directionToUv(glm::normalize(direction));
  return rgbAt(image, std::min(uint32_t(uv.x * float(image.width)), image.width - 1),
               std::min(uint32_t(uv.y * float(image.height)), image.height - 1));
}

TEST(Environments, SunIsBrightAndHasItsExactEnergy) {
  const Image sky = makeEnvironment("sky");
  const Sun sun = skySun();
  double around = 0, rest = 0, restOmega = 0, sunOmega = 0, brightest = 0;
  for (uint32_t y = 0; y < sky.height; ++y)
    for (uint32_t x = 0; x < sky.width; ++x) {
      const vec3 d =
          uvToDirection({(float(x) + 0.5f) / float(sky.width), (float(y) + 0.5f) / float(sky.height)});
      const double omega = texelSolidAngle(sky, y), green = double(sky.at(x, y)[1]);
      brightest = std::max(brightest, green);
      const bool near = glm::dot(d, sun.direction) > std::cos(1.5f * kPi / 180);
      (near ? around : rest) += omega * green;
      (near ? sunOmega : restOmega) += omega;
    }
  const double mean = rest / restOmega;
  EXPECT_GT(brightest / mean, 1e5);
  const double disc = 2 * kPiDouble * (1 - std::cos(double(sun.angularRadius)));
  const double glow = 1.9 * sunOmega;  // haze and aureole of that patch of sky, about
  EXPECT_NEAR(around, disc * double(sun.radiance.y) + glow, 0.003 * around);
  for (float value : sky.pixels) ASSERT_TRUE(std::isfinite(value) && value >= 0);
}

TEST(Environments, SunStandsWhereItSays) {
  const Image sky = makeEnvironment("sky");
  EXPECT_GT(lookUp(sky, skySun().direction).x, 0.99f * skySun().radiance.x);
  EXPECT_GT(skySun().direction.y, 0.5f);
}

TEST(Environments, AxesHaveTheirColours) {
  const Image axes = makeEnvironment("axes");
  EXPECT_EQ(lookUp(axes, {1, 0.1f, 0.2f}), Rgb(1, 0, 0));
  EXPECT_EQ(lookUp(axes, {-1, 0.1f, 0.2f}), Rgb(0, 1, 1));
  EXPECT_EQ(lookUp(axes, {0.1f, 1, 0.2f}), Rgb(0, 1, 0));
  EXPECT_EQ(lookUp(axes, {0.1f, -1, 0.2f}), Rgb(1, 0, 1));
  EXPECT_EQ(lookUp(axes, {0.1f, 0.2f, 1}), Rgb(0, 0, 1));
  EXPECT_EQ(lookUp(axes, {0.1f, 0.2f, -1}), Rgb(1, 1, 0));
}

TEST(Environments, HalfIsSplitExactlyBetweenTexels) {
  const Image half = makeEnvironment("half");
  for (uint32_t y = 0; y < half.height; ++y)
    for (uint32_t x = 0; x < half.width; ++x) {
      const vec3 d =
          uvToDirection({(float(x) + 0.5f) / float(half.width), (float(y) + 0.5f) / float(half.height)});
      ASSERT_EQ(half.at(x, y)[0], d.x > 0 ? 1.0f : 0.0f);
    }
}

TEST(Environments, TexelSunHasOneTexel) {
  const Image image = makeEnvironment("texel_sun");
  EXPECT_EQ(std::count_if(image.pixels.begin(), image.pixels.end(), [](float v) { return v != 0; }), 3);
  EXPECT_GT(image.at(kLitTexel.x, kLitTexel.y)[0], 0.0f);
}

TEST(Environments, StudioIsDarkWithColouredSoftboxes) {
  const Image studio = makeEnvironment("studio");
  EXPECT_GT(lookUp(studio, {-2.2f, 1.8f, 2.4f}).x, 10.0f);
  const Rgb blue = lookUp(studio, {0.6f, 1.2f, -3.0f});
  EXPECT_GT(blue.z, 4 * blue.x);
  size_t dark = 0;
  for (size_t i = 0; i < studio.pixels.size(); i += 3) dark += studio.pixels[i] < 0.05f;
  EXPECT_GT(double(dark) / double(studio.pixels.size() / 3), 0.7);
}

TEST(Environments, UnknownNameIsAUsageError) {
  try {
    makeEnvironment("moon");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    EXPECT_NE(std::string(error.what()).find("studio"), std::string::npos);
  }
}

}  // namespace
}  // namespace boxlight::data
