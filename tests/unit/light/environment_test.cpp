// SPDX-License-Identifier: Apache-2.0
#include "common/light/environment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"
#include "common/base/log.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "tests/unit/temporary_folder.h"

namespace boxlight {
namespace {

void setRgb(Image& image, uint32_t x, uint32_t y, Rgb value) {
  for (int c = 0; c < 3; ++c) image.at(x, y)[c] = value[c];
}

/// Texels within 45 degrees of an axis have that axis's colour.
Image axesEnvironment() {
  const Rgb colour[6] = {{1, 0, 0}, {0, 1, 1}, {0, 1, 0},
                         {1, 0, 1}, {0, 0, 1}, {1, 1, 0}};  // +X -X +Y -Y +Z -Z
  Image image = makeImage(64, 32, 3);
  for (uint32_t y = 0; y < 32; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      const vec3 d = uvToDirection({(float(x) + 0.5f) / 64.0f, (float(y) + 0.5f) / 32.0f}), a = glm::abs(d);
      const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
      setRgb(image, x, y, colour[2 * axis + (d[axis] < 0.0f)]);
    }
  return image;
}

TEST(Environment, AxesAndRotation) {
  const Image image = axesEnvironment();
  auto colour = [&](vec3 d, float degrees = 0.0f) {
    return sampleEnvironment(image, directionToUv(d) + vec2(environmentOffset(degrees), 0.0f));
  };
  EXPECT_EQ(colour({1, 0, 0}), Rgb(1, 0, 0));
  EXPECT_EQ(colour({-1, 0, 0}), Rgb(0, 1, 1)) << "across the seam";
  EXPECT_EQ(colour({0, 1, 0}), Rgb(0, 1, 0));
  EXPECT_EQ(colour({0, -1, 0}), Rgb(1, 0, 1));
  EXPECT_EQ(colour({0, 0, 1}), Rgb(0, 0, 1));
  EXPECT_EQ(colour({0, 0, -1}), Rgb(1, 1, 0));
  // A quarter turn counter-clockwise seen from above moves what was at +X to -Z.
  EXPECT_EQ(colour({0, 0, -1}, 90.0f), Rgb(1, 0, 0));
  EXPECT_EQ(colour({1, 0, 0}, 90.0f), Rgb(0, 0, 1));
  EXPECT_EQ(colour({0, 1, 0}, 90.0f), Rgb(0, 1, 0));
}

TEST(Environment, Bilinear) {
  Image image = makeImage(4, 2, 3);
  setRgb(image, 0, 0, Rgb(1.0f));
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.125f, 0.25f}).x, 1.0f) << "pixel centre";
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.25f, 0.25f}).x, 0.5f);
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.0f, 0.25f}).x, 0.5f) << "periodic";
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {1.0f, 0.25f}).x, 0.5f);
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {-0.875f, 0.25f}).x, 1.0f);
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.125f, 0.0f}).x, 1.0f) << "clamped at the pole";
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.125f, 0.5f}).x, 0.5f);
  EXPECT_FLOAT_EQ(sampleEnvironment(image, {0.125f, 1.0f}).x, 0.0f);
}

TEST(Environment, OneTexel) {
  Image image = makeImage(1, 1, 3);
  setRgb(image, 0, 0, {1, 2, 3});
  EXPECT_EQ(sampleEnvironment(image, {0.0f, 0.0f}), Rgb(1, 2, 3));
  EXPECT_EQ(sampleEnvironment(image, {0.999999f, 1.0f}), Rgb(1, 2, 3));
}

class EnvironmentFileTest : public FolderTest {};

TEST_F(EnvironmentFileTest, RepairsAndSaysSo) {
  Image image = makeImage(4, 1, 3);
  setRgb(image, 0, 0, {NAN, 2.0f, INFINITY});
  setRgb(image, 1, 0, {5.0f, -3.0f, 7.0f});
  setRgb(image, 2, 0, {INFINITY, 1.0f, -INFINITY});
  setRgb(image, 3, 0, {1.0f, 1.0f, 1.0f});
  writeImage(folder_ / "odd.exr", image);
  testing::internal::CaptureStderr();
  startLog("test", 0);
  const Image clean = readEnvironment(folder_ / "odd.exr");
  const std::string message = testing::internal::GetCapturedStderr();
  startLog("test", 0);
  EXPECT_EQ(rgbAt(clean, 0, 0), Rgb(0, 2, 7));
  EXPECT_EQ(rgbAt(clean, 1, 0), Rgb(5, 0, 7));
  EXPECT_EQ(rgbAt(clean, 2, 0), Rgb(5, 1, 0));
  EXPECT_NE(message.find("odd.exr"), std::string::npos) << message;
  EXPECT_NE(message.find("1 NaN and 2 negative"), std::string::npos) << message;
  EXPECT_NE(message.find("2 infinite"), std::string::npos) << message;
}

TEST_F(EnvironmentFileTest, WhatDevicesRoundDifferentlyIsReplaced) {
  Image image = makeImage(2, 1, 3);
  setRgb(image, 0, 0, {1e-40f, 3e38f, 1.0f});
  setRgb(image, 1, 0, {kLeastRadiance, kMostRadiance, 65504.0f});
  const Image clean = toEnvironment(image, "range");
  EXPECT_EQ(rgbAt(clean, 0, 0), Rgb(0.0f, kMostRadiance, 1.0f));
  EXPECT_EQ(rgbAt(clean, 1, 0), Rgb(kLeastRadiance, kMostRadiance, 65504.0f));
}

TEST(Environment, OversizedOnesAreAveragedWithTheirEnergy) {
  Image image = makeImage(16384, 2100, 3);  // more pixels than are kept, in less memory than 16k x 8k
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) image.at(x, y)[1] = float(x % 7) + 1.0f;
  image.at(5000, 300)[1] = 1e6f;
  const dvec3 before = totalEnergy(image);
  const Image kept = toEnvironment(std::move(image), "large");
  EXPECT_EQ(kept.width, 8192u);
  EXPECT_EQ(kept.height, 1050u);
  EXPECT_NEAR(totalEnergy(kept).y / before.y, 1.0, 1e-6);
}

TEST_F(EnvironmentFileTest, GreyAndAlphaBecomeRgb) {
  Image grey = makeImage(2, 1, 1);
  grey.pixels = {0.25f, 3.0f};
  writeImage(folder_ / "grey.exr", grey);
  EXPECT_EQ(readEnvironment(folder_ / "grey.exr").pixels,
            (std::vector<float>{0.25f, 0.25f, 0.25f, 3.0f, 3.0f, 3.0f}));
  Image rgba = makeImage(1, 1, 4);
  rgba.pixels = {1.0f, 2.0f, 3.0f, 0.0f};
  EXPECT_EQ(toEnvironment(rgba, "rgba").pixels, (std::vector<float>{1.0f, 2.0f, 3.0f}));
}

TEST_F(EnvironmentFileTest, NothingFiniteIsRefused) {
  Image image = makeImage(2, 1, 3);
  for (float& value : image.pixels) value = NAN;
  EXPECT_THROW(toEnvironment(image, "nan"), Error);
}

}  // namespace
}  // namespace boxlight
