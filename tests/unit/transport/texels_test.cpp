// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/texels.h"

#include <gtest/gtest.h>

#include "bake/transport/sampler.h"
#include "tests/support/scenes.h"

using namespace boxlight;

TEST(Texels, AreasAddUpToTheSurface) {
  Scene scene = test::makeScene(test::lambert());
  test::addSphere(scene, vec3(0), 2, 64);
  const TexelMap map = makeTexels(scene, 37, 23);
  double area = 0;
  for (const Texel& texel : map.texels) area += map.footprint(texel).back().area;
  EXPECT_NEAR(area / (4 * kPiDouble * 4), 1, 3e-3);  // the polyhedron's own deficit
  EXPECT_EQ(map.texels.size(), 37u * 23u);
}

TEST(Texels, FootprintsStayInsideTheirTexel) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0.1f), vec2(0.83f, 0.6f));
  const TexelMap map = makeTexels(scene, 16, 16);
  for (const Texel& texel : map.texels)
    for (uint32_t i = 0; i < 64; ++i) {
      Sampler sampler({1, texel.x, texel.y}, i);
      const SurfacePoint point = sampleFootprint(map.footprint(texel), sampler.next2());
      const SurfaceFrame frame = surfaceFrame(scene, point);
      const vec2 uv = glm::mix(vec2(0.1f), vec2(0.83f, 0.6f), vec2(frame.position)) * 16.0f;
      ASSERT_GE(uv.x, float(texel.x) - 1e-3f);
      ASSERT_LE(uv.x, float(texel.x + 1) + 1e-3f);
      ASSERT_GE(uv.y, float(texel.y) - 1e-3f);
      ASSERT_LE(uv.y, float(texel.y + 1) + 1e-3f);
    }
}

TEST(Texels, FootprintSamplesAreUniformInArea) {
  // One texel over two triangles of areas 1 and 3: the mean position is the area-weighted one.
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0), vec2(0.5f, 1));
  test::addQuad(scene, {10, 0, 0}, {3, 0, 0}, {0, 1, 0}, vec2(0.5f, 0), vec2(1));
  const TexelMap map = makeTexels(scene, 1, 1);
  ASSERT_EQ(map.texels.size(), 1u);
  vec3 mean(0);
  for (uint32_t i = 0; i < 1024; ++i) {
    Sampler sampler({5, 0, 0}, i);
    mean += surfaceFrame(scene, sampleFootprint(map.footprint(map.texels[0]), sampler.next2())).position /
            1024.0f;
  }
  EXPECT_NEAR(mean.x, 0.25f * 0.5f + 0.75f * 11.5f, 0.01f);
  EXPECT_NEAR(mean.y, 0.5f, 0.01f);
}

TEST(Texels, GuttersPointAtTheNearestCoveredTexel) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0.25f), vec2(0.5f));
  const TexelMap map = makeTexels(scene, 32, 32);  // texels 8 to 15 are covered
  EXPECT_EQ(map.texels.size(), 64u);
  auto at = [&](uint32_t x, uint32_t y) { return map.nearest[y * 32 + x]; };
  ASSERT_NE(at(16 + kGutterTexels - 1, 10), asset::kNone);
  EXPECT_EQ(map.texels[at(16 + kGutterTexels - 1, 10)].x, 15u);
  EXPECT_EQ(map.texels[at(16 + kGutterTexels - 1, 10)].y, 10u);
  EXPECT_EQ(at(16 + kGutterTexels, 10), asset::kNone);
  EXPECT_EQ(at(0, 0), asset::kNone);
}

TEST(Texels, ComeInBlocksOfEight) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const TexelMap map = makeTexels(scene, 32, 16);
  for (uint32_t i = 0; i < 64; ++i)
    EXPECT_TRUE(map.texels[64 + i].x / 8 == 1 && map.texels[64 + i].y / 8 == 0);
}

TEST(Texels, WhatAMaskCutsAwayWholeIsGutter) {
  asset::Material material = test::lambert();
  material.flags = asset::kAlphaMask;
  material.alphaCutoff = 0.5f;
  Scene scene = test::makeScene(material);
  scene.materials.push_back(material);
  scene.materials[1].baseColor[3] = 0.1f;
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0), vec2(0.5f, 1), 0);
  test::addQuad(scene, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0.5f, 0), vec2(1), 1);
  const TexelMap map = makeTexels(scene, 16, 16);
  EXPECT_EQ(map.texels.size(), 128u);
  EXPECT_EQ(map.texels[map.nearest[8]].x, 7u);  // the first texel of the cut half shows its uncut neighbour
}

TEST(Texels, SurvivesScalesWhoseSquaresLeaveTheRangeOfFloats) {
  for (float scale : {1e-12f, 1e12f}) {
    Scene scene = test::makeScene(test::lambert());
    test::addQuad(scene, {0, 0, 0}, {scale, 0, 0}, {0, scale, 0});
    const TexelMap map = makeTexels(scene, 2, 2);
    ASSERT_EQ(map.texels.size(), 4u);
    const float x =
        surfaceFrame(scene, sampleFootprint(map.footprint(map.texels[0]), {0.3f, 0.6f})).position.x;
    EXPECT_TRUE(x > 0 && x < 0.5f * scale) << x;
  }
}

TEST(Texels, ATriangleWithoutAtlasAreaBelongsToTheTexelItLiesIn) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec2(0.3f), vec2(0.3f));
  const TexelMap map = makeTexels(scene, 10, 10);
  ASSERT_EQ(map.texels.size(), 1u);
  EXPECT_EQ(map.texels[0].x, 3u);
  EXPECT_NEAR(map.footprint(map.texels[0]).back().area, 1, 1e-6);
}
