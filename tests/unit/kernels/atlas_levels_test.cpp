// SPDX-License-Identifier: Apache-2.0
// Coarser levels of the atlas: the same surface in fewer texels, baked for themselves.
#include <gtest/gtest.h>

#include <set>

#include "bake/kernels/scene_bake.h"
#include "bake/scene/atlas_levels.h"
#include "common/light/relight.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

/// A floor that fills the atlas, beside a wall that hides half of the sky from it.
Scene corner() {
  Scene scene = test::makeScene(test::metal(0.5f));
  scene.materials[0].metallic = 0.5f;
  scene.materials.push_back(test::lambert(Rgb(0.5f)));
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  test::addQuad(scene, {-3, 0, -1}, {6, 0, 0}, {0, 4, 0}, vec2(2), vec2(3), 1);
  test::finish(scene);
  return scene;
}

double areaOf(const TexelMap& map) {
  double area = 0;
  for (const Texel& texel : map.texels) area += double(map.footprint(texel).back().area);
  return area;
}

TEST(AtlasLevels, CoverTheSameSurface) {
  const Scene scene = corner();
  TexelMap map = makeTexels(scene, 32, 32);
  addCoarserLevels(scene, map, 3);
  ASSERT_EQ(map.coarser.size(), 2u);
  for (uint32_t level = 1; level < 3; ++level) {
    EXPECT_EQ(map.level(level).width, 32u >> level);
    EXPECT_EQ(map.level(level).texels.size(), size_t(1024) >> (2 * level));
    EXPECT_NEAR(areaOf(map.level(level)), areaOf(map), 1e-4);
  }
}

TEST(AtlasLevels, EndWhereTexelsWouldBeTooFewOrChartsWouldMix) {
  const Scene scene = corner();
  TexelMap map = makeTexels(scene, 32, 32);
  addCoarserLevels(scene, map, 8);
  EXPECT_EQ(map.coarser.back().width, kLeastLevelSize);
  Scene checkered =
      test::makeScene(test::lambert());  // 8 x 8 charts with a gutter of a sixteenth of their width
  for (int i = 0; i < 100; ++i) {
    const vec2 at = vec2(i % 8, i / 8) / 8.0f;
    test::addQuad(checkered, {float(3 * i), 0, 0}, {1, 0, 0}, {0, 0, -1}, at, at + vec2(15.0f / 128));
  }
  test::finish(checkered);
  TexelMap charts = makeTexels(checkered, 256, 256);
  addCoarserLevels(checkered, charts, 8);
  EXPECT_EQ(charts.coarser.size(), 1u) << "a gutter of two texels, then one, then half of one";
}

class BakedLevels : public ::testing::Test {
 protected:
  BakedLevels() : scene_(corner()), world_(scene_), map_(makeTexels(scene_, 20, 20)) {
    addCoarserLevels(scene_, map_, 2);
    records_ = planRecords(world_, map_, asset::Scheme::split, true);
    baked_ = bakeScene(world_, map_, records_, ViewSphere(3), {64, 8, {}, 3}, ProgressStyle::none);
  }
  const asset::Asset& asset() const { return baked_.asset; }

  Scene scene_;
  Intersector world_;
  TexelMap map_;
  std::vector<RecordPlan> records_;
  BakedScene baked_;
};

TEST_F(BakedLevels, HaveRecordsAndTilesOfTheirOwn) {
  ASSERT_EQ(asset().levelCount(), 2u);
  EXPECT_EQ(asset().records.size(), 400u + 100u);
  EXPECT_EQ(asset().levelSize(1), uvec2(10));
  std::set<uint32_t> shown;
  for (uint32_t i = 0; i < 100; ++i) {
    const uint32_t r = asset().atlasLevels[i].front;
    ASSERT_LT(r, asset().records.size());
    EXPECT_EQ(asset().records[r].level, 1u);
    EXPECT_EQ(asset().records[r].atlasX + 10 * asset().records[r].atlasY, i);
    shown.insert(r);
  }
  EXPECT_EQ(shown.size(), 100u);
  for (const asset::Tile& tile : asset().tiles)
    EXPECT_EQ(asset().records[tile.firstRecord].level,
              asset().records[tile.firstRecord + tile.recordCount - 1].level);
  EXPECT_EQ(asset().visibilityMaps.size(), asset().records.size());
}

/// They are means of the finer ones, but for the noise of both, which is of other random numbers.
TEST_F(BakedLevels, AreTheMeansOfFinerTexels) {
  Relighter relighter(asset(), [&](uint32_t stream, uint32_t tile) {
    return baked_.pages[stream * asset().tiles.size() + tile];
  });
  Image map = makeImage(32, 16, 3);
  for (size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = float(1 + i / 96 % 16) / 8.0f;
  const SummedArea light(map);
  const vec3 eye(0, 5, 3);
  double worst = 0, worstHidden = 0, worstGloss = 0, same = 0;
  for (uint32_t i = 0; i < 100; ++i) {
    TexelRadiance mean;
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t texel = (2 * (i / 10) + k / 2) * 20 + 2 * (i % 10) + k % 2;
      const TexelRadiance fine = relighter.relight(asset().atlas[texel].front, eye, light);
      mean.diffuse += fine.diffuse / 4.0, mean.glossy += fine.glossy / 4.0, mean.hidden += fine.hidden / 4;
    }
    const TexelRadiance coarse = relighter.relight(asset().atlasLevels[i].front, eye, light);
    worst = std::max(worst, std::abs(coarse.diffuse.x / mean.diffuse.x - 1));
    worstHidden = std::max(worstHidden, std::abs(coarse.hidden - mean.hidden));
    worstGloss = std::max(worstGloss, std::abs(coarse.glossy.x - mean.glossy.x));
    same += coarse.diffuse == mean.diffuse;
  }
  EXPECT_LT(worst, 0.04);
  EXPECT_LT(worstHidden, 0.15);
  EXPECT_LT(worstGloss, 0.15);
  EXPECT_EQ(same, 0);
}

TEST_F(BakedLevels, LeaveTheFinestLevelAsItWas) {
  const TexelMap alone = makeTexels(scene_, 20, 20);
  const auto records = planRecords(world_, alone, asset::Scheme::split, true);
  const BakedScene single =
      bakeScene(world_, alone, records, ViewSphere(3), {64, 8, {}, 3}, ProgressStyle::none);
  EXPECT_TRUE(single.asset.atlasLevels.empty());
  const size_t tiles = single.asset.tiles.size(), all = asset().tiles.size();
  ASSERT_LT(tiles, all);
  for (uint32_t stream = 0; stream < asset().streamCount(); ++stream)
    for (size_t t = 0; t < tiles; ++t) {
      const auto &a = single.pages[stream * tiles + t], &b = baked_.pages[stream * all + t];
      ASSERT_EQ(a.size(), b.size());
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), [](const PackedBox& x, const PackedBox& y) {
        return std::memcmp(&x, &y, sizeof x) == 0;
      }));
    }
}

}  // namespace
