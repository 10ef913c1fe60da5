// SPDX-License-Identifier: Apache-2.0
// Split lobes, pixel by pixel: the lobe behind the maps of the texels around it against wide_lobe.h, and what
// takes the place of its hidden part.
#include "tests/runtime/split_fixture.h"

namespace boxlight {
namespace {

TEST_F(SplitTest, InTheOpenAPixelIsItsLobeUnderTheLight) {
  square_.visibility = [](uint32_t) { return openMap(); };
  for (const Finish& finish :
       {metal(0.05f), metal(0.3f), metal(0.6f), metal(1.0f), varnish(0.2f), metal(0.3f, 0.8f, 0.6f)})
    EXPECT_LT(compare(finish, 0, Rgb(0)), 2e-3) << finish.material.roughness;
}

TEST_F(SplitTest, MapsClipTheLobeAndKernelsFillTheRest) {
  square_.visibility = spottedMap;
  for (const Finish& finish :
       {metal(0.05f), metal(0.3f), metal(0.6f), varnish(0.4f), metal(0.2f, 0.5f, 2.0f), brushed()})
    EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << finish.material.roughness;
}

TEST_F(SplitTest, MapsStandStillUnderALightThatTurns) {
  square_.visibility = spottedMap;  // its quarters count as even where the light's cells cut them
  for (const float degrees : {17.3f, 123.4f, 300.0f}) {
    settings_.environmentDegrees = degrees;
    for (const Finish& finish : {metal(0.05f), metal(0.2f), metal(0.6f), metal(1.0f)})
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1.5e-2)
          << degrees << ' ' << finish.material.roughness;
  }
}

TEST_F(SplitTest, ManySamplesOfACoatedStreakEndNoLoop) {
  // Mesa 22.3's lavapipe ends the loops of a lane after 65535 rounds of all of them.
  square_.visibility = spottedMap;
  Finish finish = brushed();
  finish.material.roughness = 0.15f;
  finish.material.normalTexture = {0, 0, 0};  // samples of bumpy surfaces are shaded one by one
  finish.extension.clearcoat = 1;
  finish.extension.clearcoatRoughness = 0.2f;
  use(finish);
  const auto reader = write(0.4f, Rgb(0.2f, 0.1f, 0.4f));
  settings_.camera = cameraAbove(8);
  const auto render = [&] {
    return gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  };
  const Image one = render();
  settings_.samples = 8;
  const Image many = render();
  for (uint32_t i = 0; i < one.pixels.size(); ++i)
    EXPECT_NEAR(many.pixels[i], one.pixels[i], 0.15f * one.pixels[i] + 0.05f) << i / 4;
}

TEST_F(SplitTest, CoatsAreLobesOfTheirOwnAndOthersComeFromKernels) {
  square_.visibility = spottedMap;
  for (const Finish& finish : {coated(0.5f), velvet(), frosted()})
    EXPECT_LT(compare(finish, 0.4f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << finish.material.roughness;
}

TEST_F(SplitTest, AConstantLightIsConstantWhateverIsHidden) {
  square_.visibility = spottedMap;
  for (Finish finish : {metal(0.5f), coated(0.4f), frosted()})
    for (const float hiddenPart : {0.0f, 0.25f}) {
      // Grey: what is hidden is one number for all colours.
      std::fill_n(finish.material.baseColor, 3, 0.8f);
      expectConstant(finish, hiddenPart);
    }
}

TEST_F(SplitTest, UnderAFilmPixelsAreTheirOwnLobesAndKernelsFillTheRest) {
  square_.visibility = spottedMap;
  for (const Finish& finish : {filmedMetal(0.1f), filmedMetal(0.4f), filmedVarnish(0.3f), filmedMetal(0.25f)})
    for (const uint32_t frequency : {0u, 3u}) {
      square_.directionCells = frequency;
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2)
          << frequency << ' ' << finish.material.roughness;
    }
}

TEST_F(SplitTest, UnderAFilmAConstantLightIsItsReflectanceWhateverIsHidden) {
  square_.visibility = spottedMap;
  one_ = true;
  Finish finish = filmedMetal(0.4f);
  finish.extension.iridescenceThickness[1] = 1e5f;  // grey: without interference
  for (const uint32_t frequency : {0u, 2u})
    for (const float hiddenPart : {0.0f, 0.25f}) {
      square_.directionCells = frequency;
      expectConstant(finish, hiddenPart);
    }
}

/// A mirror in the open has no kernel at all: its pools are empty.
TEST_F(SplitTest, WithoutAnyKernelsAPixelIsItsLobe) {
  square_.visibility = [](uint32_t) { return openMap(); };
  square_.diffuseBoxes = 0;
  Finish finish = metal(0.3f);
  std::fill_n(finish.material.baseColor, 3, 0.8f);
  expectConstant(finish, 0);
}

TEST_F(SplitTest, BesideWholeLobesSplitOnesHaveTheirPart) {
  square_.visibility = spottedMap;
  half_ = true;
  EXPECT_LT(compare(metal(0.4f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2);
}

TEST_F(SplitTest, SmallTexelBuffersLeaveThePictureAsItIs) {
  square_.visibility = spottedMap;
  use(coated(0.4f));
  const auto reader = write(0.4f, Rgb(0.2f, 0.1f, 0.4f));
  ASSERT_TRUE(device_->limits().texelBuffers);
  const Image large = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  device_ = std::make_unique<gpu::Device>(gpu::DeviceOptions{"", true, false});
  ASSERT_FALSE(device_->limits().texelBuffers);
  const Image small = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  EXPECT_EQ(large.pixels, small.pixels);
}

TEST_F(SplitTest, ThePictureOfAnAssetWithoutSplitLobesNeedsNoMaps) {
  settings_.camera = cameraAbove(16);
  const auto whole = square_.write(file("whole.ptb"), [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.5f)};
  });
  square_.visibility = [](uint32_t) { return openMap(); };
  gpu::FrameRenderer plain(*device_, whole, skyEnvironment(), settings_);
  gpu::FrameRenderer split(*device_, write(0.5f, Rgb(0)), skyEnvironment(), settings_);
  EXPECT_EQ(
      split.counts().sceneBytes - plain.counts().sceneBytes,
      kEdge * kEdge *
          (sizeof(uint32_t) * (1 + gpu::kMapBlockWords + gpu::kMapQuarterWords) + sizeof(VisibilityMap)));
}

}  // namespace
}  // namespace boxlight
