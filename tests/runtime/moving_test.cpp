// SPDX-License-Identifier: Apache-2.0
// A renderer that has been elsewhere draws what a new one draws, bit for bit.
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

Box anyBox(uint32_t stream, uint32_t record, uint32_t slot) {
  const uint32_t seed = stream * 37 + record * 11 + slot * 5;
  return {float(seed % 13) / 13, float(seed % 7) / 14, 0.3f, 0.4f, Rgb(float(seed % 5 + 1))};
}

class MovingTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    settings_.camera = cameraAbove(24);
    settings_.camera.eye = {0.4f, 1.4f, 0.6f};
    settings_.camera.tanHalfFov = 0.5f;
    settings_.lightSize = {64, 32};
  }

  /// One renderer through `steps`, each against a renderer of its own.
  void follow(const asset::AssetReader& reader, std::span<const std::function<void()>> steps) {
    gpu::FrameRenderer moving(*device_, reader, light_, settings_);
    for (size_t i = 0; i < steps.size(); ++i) {
      steps[i]();
      moving.set(settings_, &light_);
      moving.run();
      gpu::FrameRenderer fresh(*device_, reader, light_, settings_);
      EXPECT_EQ(moving.picture().pixels, fresh.picture().pixels) << "step " << i;
      EXPECT_EQ(moving.counts().boxes, fresh.counts().boxes) << "step " << i;
      EXPECT_GE(moving.counts().pages, fresh.counts().pages) << "step " << i;
    }
  }

  /// Everything that may change, in an order that grows and shrinks buffers.
  std::vector<std::function<void()>> allSteps() {
    return {[&] {
              settings_.camera.eye = {-0.7f, 0.9f, 0.1f};
            },
            [&] {
              settings_.camera.size = {50, 31};
            },
            [&] {
              settings_.camera.size = {9, 40};
            },
            [&] { settings_.background = false; },
            [&] {
              light_ = axesEnvironment({32, 16});
            },
            [&] {
              settings_.lightSize = {40, 20};
            },
            [&] { settings_.samples = 3; },
            [&] { settings_.tileEdge = 11; },
            [&] { settings_.background = true; },
            [&] { settings_.environmentDegrees = 77; },
            [&] {
              settings_.environmentTilt = {20, -35};
            },
            [&] { settings_.environmentIntensity = 3; },
            [&] { settings_.satScheme = gpu::SatScheme::exact; },
            [&] { settings_.environmentTilt = {}; },
            [&] { settings_.satScheme = gpu::SatScheme::compact; },
            [&] { settings_.layerLimit = 1; },
            [&] { settings_.boxLimit = 1; },
            [&] { settings_.interpolation = Interpolation::weight; },
            [&] {
              settings_.camera.eye = {0.2f, 2.4f, -0.9f};
            }};
  }

  /// What depends on the size of image tiles and on what is visible.
  std::vector<std::function<void()>> someSteps() {
    return {[&] {
              settings_.camera.eye = {-0.7f, 0.9f, 0.1f};
            },
            [&] {
              settings_.camera.size = {50, 31};
            },
            [&] {
              settings_.camera.size = {9, 40}, settings_.samples = 3, settings_.tileEdge = 11;
            },
            [&] { settings_.layerLimit = 1; },
            [&] {
              settings_.camera.eye = {0.2f, 2.4f, -0.9f};
            }};
  }

  /// The same, and another table for pixels to integrate their lobes over.
  std::vector<std::function<void()>> splitSteps() {
    auto steps = someSteps();
    steps.push_back([&] { settings_.satScheme = gpu::SatScheme::exact; });
    steps.push_back([&] { settings_.boxLimit = 1; });
    steps.push_back([&] { settings_.satScheme = gpu::SatScheme::compact; });
    return steps;
  }

  /// A mirror whose texels see a row each; `cells`: Square::directionCells.
  asset::AssetReader writeSplit(const char* name, uint32_t cells) {
    Square square;
    square.atlasEdge = 16;
    square.glossyBoxes = 2;
    square.material.metallic = 1;
    square.directionCells = cells;
    square.visibility = [](uint32_t record) {
      VisibilityMap map{};
      for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) map.setVisible(x, record % VisibilityMap::kRows);
      return map;
    };
    const asset::Asset asset = square.makeAsset();
    return writeSynthetic(file(name), asset, [&](uint32_t stream, uint32_t record, uint32_t slot) {
      if (stream == asset.diffuseStream() || slot > 0) return packBox(anyBox(stream, record, slot));
      return packHiddenPart(0.25f);
    });
  }

  gpu::FrameSettings settings_;
  Image light_ = axesEnvironment({64, 32});
};

TEST_F(MovingTest, GlossyKernels) {
  Square square;
  square.glossyBoxes = 2;
  square.material.specular = 1;
  follow(square.write(file("gloss.ptb"), anyBox), allSteps());
}

/// The device keeps them for all renderers, so that only another device can tell.
TEST_F(MovingTest, ShadersAreKeptByTheirConstants) {
  Square square;
  const auto reader = square.write(file("constants.ptb"), anyBox);
  const gpu::FrameRenderer before(*device_, reader, light_, settings_);
  settings_.background = false;
  gpu::FrameRenderer after(*device_, reader, light_, settings_);
  gpu::Device other(gpu::DeviceOptions{"", true});
  gpu::FrameRenderer alone(other, reader, light_, settings_);
  EXPECT_EQ(after.picture().pixels, alone.picture().pixels);
}

/// A view is the same at another size: the window draws each in two.
TEST_F(MovingTest, WaitsForPagesBelongToAView) {
  Square square;
  const auto reader = square.write(file("waits.ptb"), anyBox);
  gpu::FrameRenderer renderer(*device_, reader, light_, settings_);
  const double first = renderer.counts().pageMilliseconds;
  EXPECT_GT(first, 0);
  settings_.camera.size = {50, 31};
  renderer.set(settings_);
  renderer.run();
  const double both = renderer.counts().pageMilliseconds;
  EXPECT_GT(both, first);
  renderer.run();
  EXPECT_EQ(renderer.counts().pageMilliseconds, both);
  settings_.camera.eye = {-0.7f, 0.9f, 0.1f};
  renderer.set(settings_);
  EXPECT_EQ(renderer.counts().pageMilliseconds, 0);
  renderer.run();
  EXPECT_GT(renderer.counts().pageMilliseconds, 0);
}

TEST_F(MovingTest, BlendedLayers) {
  Square square;
  square.material.baseColor[3] = 0.5f;
  square.material.flags = asset::kAlphaBlend;
  square.extensions.resize(1);
  asset::Asset asset = square.makeAsset();
  asset.triangles.insert(asset.triangles.end(), asset.triangles.begin(), asset.triangles.begin() + 2);
  const auto kernel = [](uint32_t s, uint32_t r, uint32_t j) { return packBox(anyBox(s, r, j)); };
  follow(writeSynthetic(file("layers.ptb"), asset, kernel), someSteps());
}

TEST_F(MovingTest, VisibilityMaps) {
  settings_.camera.tanHalfFov = 0.2f;  // a part of the square at a time
  follow(writeSplit("split.ptb", 0), splitSteps());
}

/// What is seen later has no room in the first pool: pixels, which read kernels themselves, look for it in
/// more.
TEST_F(MovingTest, DirectionCells) {
  settings_.camera.tanHalfFov = 0.2f;
  const auto reader = writeSplit("cells.ptb", 3);
  settings_.poolBytes = gpu::FrameRenderer(*device_, reader, light_, settings_).counts().pageBytes;
  follow(reader, splitSteps());
}

/// Pools that hold one camera's pages, but not two cameras'.
TEST_F(MovingTest, WhatIsNotNeededMakesRoom) {
  Square square;
  square.atlasEdge = 16;
  square.glossyBoxes = 3;
  square.material.specular = 1;
  const auto reader = square.write(file("room.ptb"), anyBox);
  settings_.poolBytes = gpu::FrameRenderer(*device_, reader, light_, settings_).counts().pageBytes / 3;
  gpu::FrameRenderer moving(*device_, reader, light_, settings_);
  for (const vec3 eye : {vec3(-2, 0.7f, 0), vec3(0, 0.6f, 2), vec3(2, 0.5f, 0), vec3(0.4f, 1.4f, 0.6f)}) {
    settings_.camera.eye = eye;
    moving.set(settings_);
    moving.run();
    gpu::FrameRenderer fresh(*device_, reader, light_, settings_);
    EXPECT_EQ(moving.picture().pixels, fresh.picture().pixels);
    EXPECT_LE(moving.counts().pageBytes, 4 * settings_.poolBytes);
  }
}

}  // namespace
}  // namespace boxlight
