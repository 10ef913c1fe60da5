// SPDX-License-Identifier: Apache-2.0
// What the window shows is what a PNG holds.
#include "runtime/kernels/display.h"

#include <cmath>

#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

using gpu::Display;

class DisplayTest : public GpuTest {
 protected:
  void show(Display& display, const Image& image) {
    std::vector<vec4> pixels;
    for (size_t i = 0; i < image.pixels.size(); i += 4)
      pixels.emplace_back(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2], image.pixels[i + 3]);
    const uvec2 size(image.width, image.height);
    display.beginPicture(size);
    display.addTile(gpu::makeBuffer(*device_, "picture", pixels), {{0, 0}, size});
    display.endPicture();
  }
  static int channel(uint32_t word, uint32_t c) { return int(word >> 8 * c & 255u); }
};

/// A ramp over 16 stops in three hues, and what is no radiance.
Image testPicture() {
  Image image = makeImage(97, 3, 4);
  for (uint32_t x = 0; x < image.width; ++x) {
    const float level = std::exp2(float(x) / 6 - 8);
    for (uint32_t y = 0; y < 3; ++y) {
      float* p = image.at(x, y);
      p[0] = level;
      p[1] = y == 0 ? level : 0.3f * level;
      p[2] = y == 2 ? 0.0f : level;
      p[3] = 1;
    }
  }
  image.at(0, 0)[0] = -1;
  image.at(1, 0)[1] = std::numeric_limits<float>::infinity();
  return image;
}

TEST_F(DisplayTest, CurvesAreThoseOfTheCpu) {
  const Image image = testPicture();
  Display display(*device_);
  show(display, image);
  for (const ToneMap map : {ToneMap::none, ToneMap::reinhard, ToneMap::aces, ToneMap::neutral})
    for (const float exposure : {0.0f, -2.5f, 3.0f}) {
      display.compose({image.width, image.height}, map, exposure, ~0u);
      const auto words = display.read();
      const Image expected = toDisplay(image, exposure, map);
      double worst = 0;
      for (size_t i = 0; i < words.size(); ++i)
        for (uint32_t c = 0; c < 3; ++c) {
          const double difference =
              std::abs(255.0 * double(expected.pixels[4 * i + c]) - channel(words[i], c));
          worst = std::max(worst, difference);
        }
      EXPECT_LT(worst, 0.51) << kToneMapNames[size_t(map)] << " at " << exposure << " EV";
    }
}

TEST_F(DisplayTest, TheTruthBeginsAtTheSplit) {
  Image left = makeImage(8, 4, 4), right = makeImage(8, 4, 3);
  for (size_t i = 0; i < left.pixels.size(); i += 4) left.pixels[i] = left.pixels[i + 3] = 1;
  for (size_t i = 0; i < right.pixels.size(); i += 3) right.pixels[i + 1] = 1;
  Display display(*device_);
  show(display, left);
  display.setTruth(right);
  display.compose({8, 4}, ToneMap::none, 0, 5);
  const auto words = display.read();
  for (uint32_t x = 0; x < 8; ++x) {
    if (x == 4) continue;  // the line
    EXPECT_EQ(channel(words[8 + x], 0), x < 4 ? 255 : 0) << x;
    EXPECT_EQ(channel(words[8 + x], 1), x < 4 ? 0 : 255) << x;
  }
}

TEST_F(DisplayTest, SmallPicturesAreStretchedWithoutAShift) {
  Image ramp = makeImage(4, 1, 4);
  for (uint32_t x = 0; x < 4; ++x)
    for (int c = 0; c < 4; ++c) ramp.at(x, 0)[c] = c == 3 ? 1.0f : decodeSrgb(float(x) / 4);
  Display display(*device_);
  show(display, ramp);
  display.compose({12, 3}, ToneMap::none, 0, ~0u);
  const auto words = display.read();
  for (uint32_t x = 0; x < 4; ++x)  // the middle of each pixel's three
    EXPECT_NEAR(channel(words[12 + 3 * x + 1], 0), 255 * x / 4.0, 1.0);
}

TEST_F(DisplayTest, APictureIsShownWhenItIsComplete) {
  Image first = makeImage(2, 2, 4);
  std::fill(first.pixels.begin(), first.pixels.end(), 1.0f);
  Display display(*device_);
  show(display, first);
  const std::vector<vec4> black(2, vec4(0, 0, 0, 1));
  const gpu::Buffer row = gpu::makeBuffer(*device_, "row", black);
  const auto shown = [&] {
    display.compose({2, 2}, ToneMap::none, 0, ~0u);
    return channel(display.read()[0], 0);
  };
  display.beginPicture({2, 2});
  display.addTile(row, {{0, 0}, {2, 1}});
  EXPECT_EQ(shown(), 255);
  display.addTile(row, {{0, 1}, {2, 1}});
  display.endPicture();
  EXPECT_EQ(shown(), 0);
}

TEST_F(DisplayTest, NothingIsAChecker) {
  Display display(*device_);
  show(display, makeImage(16, 8, 4));
  display.compose({16, 8}, ToneMap::none, 0, ~0u);
  const auto words = display.read();
  EXPECT_NE(words[0], words[8]);
  EXPECT_EQ(words[0], words[7]);
}

}  // namespace
}  // namespace boxlight
