// SPDX-License-Identifier: Apache-2.0
#include "common/image/image_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"

namespace boxlight {
namespace {

Image constant(uint32_t width, uint32_t height, uint32_t channels, float value) {
  Image image = makeImage(width, height, channels);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

TEST(ImageMetrics, ByHand) {
  Image reference = constant(2, 1, 3, 0.5f), image = reference;
  image.at(0, 0)[0] = 0.7f;  // one of six values differs by .2
  const ImageMetrics m = compareImages(image, reference);
  EXPECT_NEAR(m.rmse, 0.2 / std::sqrt(6.0), 1e-7);
  EXPECT_NEAR(m.trimmedRmse, m.rmse, 1e-12) << "two pixels: a thousandth is none";
  EXPECT_NEAR(m.relMse, 0.04 / (0.25 + 0.01) / 6.0, 1e-7);
  EXPECT_NEAR(m.bias, 0.2 / 6.0 / 0.5, 1e-6);
  EXPECT_NEAR(m.referenceMean, 0.5, 1e-12);
  const double steps = 255.0 * (0.8543058 - 0.7353570);  // sRGB of .7 and .5
  EXPECT_NEAR(m.rmse8, steps / std::sqrt(6.0), 1e-4);
  EXPECT_NEAR(m.psnr, 20.0 * std::log10(255.0 / m.rmse8), 1e-9);
  EXPECT_EQ(m.pixels, 2u);
  EXPECT_FALSE(m.byAlpha);
}

TEST(ImageMetrics, EqualPictures) {
  const Image image = constant(3, 3, 4, 0.8f);
  const ImageMetrics m = compareImages(image, image);
  EXPECT_EQ(m.rmse, 0.0);
  EXPECT_EQ(m.bias, 0.0);
  EXPECT_TRUE(std::isinf(m.psnr));
}

TEST(ImageMetrics, TrimsOnePixelInAThousand) {
  Image reference = constant(50, 40, 3, 1.0f), image = constant(50, 40, 3, 1.1f);
  image.at(7, 7)[1] = image.at(8, 30)[2] = 1000.0f;  // two fireflies of 2000 pixels
  const ImageMetrics m = compareImages(image, reference);
  EXPECT_GT(m.rmse, 10.0);
  EXPECT_NEAR(m.trimmedRmse, 0.1, 1e-6);
  image.at(9, 9)[0] = 1000.0f;
  EXPECT_GT(compareImages(image, reference).trimmedRmse, 1.0);
}

TEST(ImageMetrics, AlphaOfTheReferenceChooses) {
  Image reference = constant(2, 1, 4, 1.0f), image = reference;
  reference.at(1, 0)[3] = 0.5f;
  image.at(1, 0)[0] = NAN;  // outside the object: not even looked at
  const ImageMetrics m = compareImages(image, reference);
  EXPECT_EQ(m.rmse, 0.0);
  EXPECT_EQ(m.pixels, 1u);
  EXPECT_EQ(m.allPixels, 2u);
  EXPECT_TRUE(m.byAlpha);
  reference.at(0, 0)[3] = 0.0f;
  EXPECT_THROW(compareImages(image, reference), Error);
}

TEST(ImageMetrics, ChannelsMayDiffer) {
  EXPECT_NEAR(compareImages(constant(2, 2, 1, 0.3f), constant(2, 2, 4, 0.7f)).rmse, 0.4, 1e-6);
}

TEST(ImageMetrics, BadPixelsAndSizesAreInvalidInput) {
  const Image good = constant(4, 3, 3, 1.0f);
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    Image image = good;
    image.at(2, 1)[1] = bad;
    for (const bool swapped : {false, true}) try {
        swapped ? compareImages(good, image) : compareImages(image, good);
        FAIL();
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalidInput);
        EXPECT_NE(std::string(error.what()).find("(2, 1)"), std::string::npos) << error.what();
      }
  }
  EXPECT_THROW(compareImages(good, constant(3, 4, 3, 1.0f)), Error);
}

TEST(FalseColour, ScaleAndMask) {
  Image reference = constant(4, 1, 4, 0.0f), image = reference;
  for (uint32_t x = 0; x < 3; ++x) reference.at(x, 0)[3] = 1.0f;
  image.at(1, 0)[2] = decodeSrgb(7.0f / 255.0f);  // log2(1 + 7) / 6 = 1/2
  image.at(2, 0)[0] = 1.0f;
  const Image difference = falseColourDifference(image, reference);
  ASSERT_EQ(difference.channels, 4u);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(difference.at(0, 0)[c], 0.0f);
    EXPECT_NEAR(difference.at(1, 0)[c], cubehelix(0.5f)[c], 1e-4f);
    EXPECT_NEAR(difference.at(2, 0)[c], 1.0f, 1e-6f);
  }
  EXPECT_EQ(difference.at(0, 0)[3], 1.0f);
  EXPECT_EQ(difference.at(3, 0)[3], 0.0f);
}

TEST(FalseColour, BrightnessRises) {
  float last = -1.0f;
  for (int i = 0; i <= 100; ++i) {
    const Rgb c = cubehelix(float(i) / 100.0f);
    const float brightness = 0.30f * c.x + 0.59f * c.y + 0.11f * c.z;
    EXPECT_GT(brightness, last) << i;
    last = brightness;
  }
}

}  // namespace

TEST(ImageMetrics, CoverageIsMeasuredOverAllPixels) {
  Image reference = makeImage(4, 1, 4), image = makeImage(4, 1, 4);
  reference.at(0, 0)[3] = image.at(0, 0)[3] = 1;
  image.at(3, 0)[3] = 1;  // the reference is empty there
  EXPECT_DOUBLE_EQ(compareImages(image, reference).rmse, 0);
  EXPECT_DOUBLE_EQ(compareImages(image, reference).alphaRmse, 0.5);
}

}  // namespace boxlight
