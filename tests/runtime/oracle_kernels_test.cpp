// SPDX-License-Identifier: Apache-2.0
// The shading pass against the oracle: kernels that begin with other slots than boxes, and records of other
// spheres of views.
#include "tests/runtime/oracle_fixture.h"

namespace boxlight {
namespace {

/// Slot 0 emits: nothing, little, or more than a half float holds; the boxes follow.
PackedBox emittingKernel(uint32_t stream, uint32_t record, uint32_t slot) {
  if (slot > 0) return packBox(matchedBox(stream, record, slot));
  std::mt19937 random(stream * 31u + record * 65537u);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  const float scale = record % 3 == 0 ? 0.0f : record % 3 == 1 ? 1.0f : 1e6f;
  return packEmission(scale * Rgb(uniform(random), uniform(random), uniform(random)));
}

TEST_F(OracleTest, EmittedRadianceDoesNotDependOnTheLight) {
  Square square;
  square.atlasEdge = 20;
  square.glossyBoxes = 4;
  square.diffuseBoxes = 3;
  square.extensions.resize(1);
  const auto reader = writeSynthetic(file("emit.ptb"), square.makeAsset(), emittingKernel);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  for (const Interpolation interpolation : {Interpolation::energy, Interpolation::weight}) {
    settings_.interpolation = interpolation;
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
  }
  settings_.boxLimit = 1;  // of the light; the emitted slot is always taken
  EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
  const Image dark = constantEnvironment({64, 32}, Rgb(0));
  gpu::FrameRenderer renderer(*device_, reader, dark, settings_);
  EXPECT_EQ(renderer.counts().boxes, 20u * 20u * 2);
  const auto shaded = renderer.readShaded();
  for (uint32_t r = 0; r < 400; ++r) {
    const Rgb emitted = unpackEmission(emittingKernel(reader.asset().diffuseStream(), r, 0));
    for (int c = 0; c < 3; ++c) ASSERT_FLOAT_EQ(shaded[2 * r][c], emitted[c]) << r;
  }
}

TEST_F(OracleTest, EmittedRadianceOfOneKindOfStreamAlone) {
  Square square;
  square.atlasEdge = 8;
  square.glossyBoxes = 2;
  square.extensions.resize(1);
  const asset::Asset asset = square.makeAsset();
  const auto kernel = [&](uint32_t stream, uint32_t record, uint32_t slot) {
    return stream == asset.diffuseStream() ? packBox(matchedBox(stream, record, slot))
           : slot == 0                     ? packEmission(Rgb(3, 2, 0.5f))
                                           : packBox(matchedBox(stream, record, slot));
  };
  const auto reader = writeSynthetic(file("gloss.ptb"), asset, kernel);
  EXPECT_EQ(compare(reader, environmentWithSun(1.0f)), 64u);
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(0)), settings_);
  EXPECT_EQ(renderer.counts().boxes, 64u * 2);
  const auto shaded = renderer.readShaded();
  for (const auto& [r, glossy] : renderer.readVisible()) {
    EXPECT_EQ(shaded[2 * r], vec4(0));
    EXPECT_NEAR(shaded[2 * r + 1].x, 3.0f, 1e-5f);  // whatever the view
  }
}

TEST_F(OracleTest, SplitLobesKeepEveryViewsHiddenPart) {
  Square square;
  square.atlasEdge = 20;
  square.visibility = [](uint32_t) { return VisibilityMap(); };
  square.extensions.resize(1);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  for (const uint32_t emission : {0u, 1u}) {
    square.glossyBoxes = emission + 1 + 3;
    asset::Asset asset = square.makeAsset();
    for (uint32_t view = 0; view < asset.info.viewCount; view += 3)  // hide nothing of some records
      for (uint64_t tile = 0; tile < asset.tiles.size(); ++tile)
        asset.streamMasks[view * asset.tiles.size() + tile] &= 0xF0F0F0F0F0F0F0F0u;
    const auto kernel = [&](uint32_t stream, uint32_t record, uint32_t slot) {
      if (stream == asset.diffuseStream() || slot > emission) return packBox(randomBox(stream, record, slot));
      return slot == emission ? packHiddenPart(float(1 + (stream + record) % 9) / 16.0f)
                              : emittingKernel(stream, record, 0);
    };
    const auto reader = writeSynthetic(file("split.ptb"), asset, kernel);
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
    gpu::FrameRenderer renderer(*device_, reader, environmentWithSun(1.0f), settings_);
    EXPECT_EQ(renderer.counts().boxes, 20u * 20u * (1 + 3 * 3));
    settings_.boxLimit = 2;
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
    settings_.boxLimit = ~0u;
  }
}

TEST_F(OracleTest, RecordsReadTheViewsOfTheirOwnSpheres) {
  Square square;
  square.atlasEdge = 20;
  square.glossyBoxes = 4;
  square.viewFrequency = 4;
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  asset::Asset asset = square.makeAsset();
  asset.coarseViews = {{3, 92}, {2, 42}, {1, 12}};
  for (uint32_t r = 0; r < asset.records.size(); ++r)
    asset.records[r].flags |= r % 4 << asset::kViewSphereShift;
  for (uint32_t view = 0; view < asset.info.viewCount; ++view)
    for (size_t tile = 0; tile < asset.tiles.size(); ++tile) {
      uint64_t& mask = asset.streamMasks[view * asset.tiles.size() + tile];
      mask = ~uint64_t(0) >> (64 - asset.tiles[tile].recordCount);
      for (uint32_t sphere = 1; sphere < 4; ++sphere)  // tiles begin at multiples of 64
        if (view >= asset.coarseViews[sphere - 1].count) mask &= ~(0x1111111111111111u << sphere);
    }
  const auto reader = writeSynthetic(file("spheres.ptb"), asset, [](uint32_t s, uint32_t r, uint32_t slot) {
    return packBox(randomBox(s, r, slot));
  });
  EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
}

}  // namespace
}  // namespace boxlight
