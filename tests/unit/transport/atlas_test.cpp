// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/atlas.h"

#include <gtest/gtest.h>

#include "bake/scene/bleeding.h"
#include "bake/scene/uv_set.h"
#include "common/base/error.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

Scene twoQuads(vec2 secondMin, vec2 secondMax) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, vec2(0), vec2(0.5f, 1));
  test::addQuad(scene, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, secondMin, secondMax);
  return scene;
}

}  // namespace

TEST(Atlas, AcceptsASetThatTouchesItselfOnlyAtEdges) {
  Scene scene = twoQuads(vec2(0.5f, 0), vec2(1));
  const UvSetReport report = inspectUvSet(scene, 0);
  EXPECT_EQ(report.fault(), "");
  EXPECT_EQ(report.overlap, 0);  // shared edges and diagonals are counted once
  EXPECT_EQ(chooseAtlas(scene, {}).uvSet, 0u);
}

TEST(Atlas, MeasuresOverlap) {
  const Scene scene = twoQuads(vec2(0.25f, 0), vec2(0.75f, 1));
  EXPECT_NEAR(inspectUvSet(scene, 0).overlap, 0.25 / 0.75, 1e-3);
}

TEST(Atlas, RefusesWhatLeavesTheUnitSquareOrHasNoArea) {
  EXPECT_FALSE(inspectUvSet(twoQuads(vec2(0.5f, 0), vec2(1.5f, 1)), 0).inside);
  EXPECT_NEAR(inspectUvSet(twoQuads(vec2(0.7f), vec2(0.7f)), 0).collapsed, 0.5, 1e-6);
}

TEST(Atlas, FallsBackToTheSecondSet) {
  Scene scene = twoQuads(vec2(0.25f, 0), vec2(0.75f, 1));
  const Scene good = twoQuads(vec2(0.5f, 0), vec2(1));
  for (size_t i = 0; i < scene.vertices.size(); ++i)
    for (int k = 0; k < 2; ++k) scene.vertices[i].uv[1][k] = good.vertices[i].uv[0][k];
  scene.hasTexcoord[1] = true;
  EXPECT_EQ(chooseAtlas(scene, {}).uvSet, 1u);
  EXPECT_EQ(scene.vertices[5].atlasUv[0], good.vertices[5].uv[0][0]);
}

TEST(Atlas, ChartsWhereNoSetFitsAndSaysWhy) {
  Scene scene = twoQuads(vec2(0.25f, 0), vec2(0.75f, 1));
  const AtlasReport report = chooseAtlas(scene, {});
  EXPECT_EQ(report.uvSet, asset::kNone);
  EXPECT_EQ(report.charting.charts, 2u);
  EXPECT_EQ(report.reason,
            "TEXCOORD_0 overlaps itself on 33.3 % of its area; TEXCOORD_1 is missing on some primitive");
}

TEST(Atlas, ChartsWhereASetStarvesPartOfTheSurface) {
  // Two squares of equal size, the second with a twentieth and a fifth of the first one's texels per metre.
  for (const float side : {0.045f, 0.18f}) {
    Scene scene = test::makeScene(test::lambert());
    test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, vec2(0), vec2(0.9f));
    test::addQuad(scene, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, vec2(1 - side / 2), vec2(1));
    const AtlasReport report = chooseAtlas(scene, {});
    EXPECT_EQ(report.uvSet, side < 0.1f ? asset::kNone : 0u) << report.summary();
  }
}

TEST(Atlas, ChartsWhereASetLetsItsChartsBleed) {
  // 8 x 8 squares apart, each with an eighth of the unit square less a gutter of 3/8 or 3 texels on every
  // side.
  for (const uint32_t size : {32u, 256u}) {
    Scene scene = test::makeScene(test::lambert());
    for (int i = 0; i < 64; ++i) {
      const vec2 at(i % 8, i / 8);
      test::addQuad(scene, {at.x, 0, at.y}, {0.9f, 0, 0}, {0, 0, -0.9f}, (at + 3.0f / 32) / 8.0f,
                    (at + 29.0f / 32) / 8.0f);
    }
    const AtlasReport report = chooseAtlas(scene, {.size = size});
    EXPECT_EQ(report.uvSet, size == 32 ? asset::kNone : 0u) << report.summary();
    EXPECT_EQ(report.reason.starts_with("TEXCOORD_0 lets its charts bleed into each other by"), size == 32);
    EXPECT_LT(measureBleeding(scene, size), 1e-3) << report.summary();
  }
}

TEST(Atlas, AnAskedSetMustFit) {
  Scene scene = twoQuads(vec2(0.25f, 0), vec2(0.75f, 1));
  try {
    chooseAtlas(scene, {.source = AtlasSource::texcoord0});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::unsupported);
    EXPECT_NE(std::string(error.what()).find("TEXCOORD_0 cannot be the atlas: it overlaps itself on 33.3 %"),
              std::string::npos)
        << error.what();
  }
}
