// SPDX-License-Identifier: Apache-2.0
#include "common/image/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/image/image.h"

namespace boxlight {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::array kAll = {ToneMap::none, ToneMap::reinhard, ToneMap::aces, ToneMap::neutral};

void expectNear(Rgb value, Rgb expected, float tolerance = 1e-6f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << "channel " << c;
}

TEST(ToneMapTest, KnownValues) {
  expectNear(applyToneMap(ToneMap::none, {0.25f, 1.0f, 7.0f}), {0.25f, 1, 1});
  expectNear(applyToneMap(ToneMap::reinhard, {0, 1, 3}), {0, 0.5f, 0.75f});
  // 1 (2.51 + .03) / (2.43 + .59 + .14), and a tenth of it all by hand
  expectNear(applyToneMap(ToneMap::aces, {0, 1, 0.1f}), {0, 2.54f / 3.16f, 0.0281f / 0.2233f});
  // Below the shoulder the reflection of .04 goes, of a dark colour 6.25 x^2 of its smallest channel x stays.
  expectNear(applyToneMap(ToneMap::neutral, {0.3f, 0.5f, 0.7f}), {0.26f, 0.46f, 0.66f});
  expectNear(applyToneMap(ToneMap::neutral, {0.04f, 0.5f, 0.04f}), {0.01f, 0.47f, 0.01f});
}

// At the shoulder's start the curve meets the identity in value and slope.
TEST(ToneMapTest, NeutralIsSmoothAtItsShoulder) {
  const auto grey = [](float x) { return applyToneMap(ToneMap::neutral, Rgb(x)).x; };
  EXPECT_NEAR(grey(0.8f), 0.76f, 1e-6f);
  EXPECT_NEAR((grey(0.81f) - grey(0.8f)) / 0.01f, 1.0f, 0.05f);
}

TEST(ToneMapTest, GreyStaysGreyAndRises) {
  for (const ToneMap map : kAll) {
    float last = -1e-9f;
    for (float x = 0; x < 40; x = x * 1.03f + 1e-4f) {
      const Rgb y = applyToneMap(map, Rgb(x));
      EXPECT_EQ(y.x, y.y);
      EXPECT_EQ(y.x, y.z);
      EXPECT_GE(y.x, last) << kToneMapNames[size_t(map)] << " at " << x;
      EXPECT_LE(y.x, 1.0f);
      last = y.x;
    }
    EXPECT_GT(last, 0.95f);
  }
}

TEST(ToneMapTest, WhatIsNoRadianceIsNeverNaN) {
  for (const ToneMap map : kAll) {
    expectNear(applyToneMap(map, {NAN, -1, -kInfinity}), Rgb(0));
    for (const float huge : {1e6f, 1e20f, 3e38f, kInfinity})
      expectNear(applyToneMap(map, Rgb(huge)), Rgb(1), 2e-6f);
    const Rgb lopsided = applyToneMap(map, {kInfinity, 0, NAN});
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(lopsided[c] >= 0.0f && lopsided[c] <= 1.0f);
  }
}

TEST(ToneMapTest, DisplayMapsStraightColours) {
  Image image = makeImage(1, 1, 4);
  for (int c = 0; c < 4; ++c) image.pixels[size_t(c)] = 0.5f;  // white at half coverage
  for (const ToneMap map : kAll) {
    const Image display = toDisplay(image, 1.0f, map);
    EXPECT_FLOAT_EQ(display.pixels[0], encodeSrgb(applyToneMap(map, Rgb(2)).x));
    EXPECT_EQ(display.pixels[3], 0.5f);
  }
}

}  // namespace
}  // namespace boxlight
