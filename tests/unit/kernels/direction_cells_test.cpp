// SPDX-License-Identifier: Apache-2.0
// Which records have direction cells, and that the kernels in their streams are those of their directions.
#include <gtest/gtest.h>

#include "bake/kernels/scene_bake.h"
#include "common/light/relight.h"
#include "tests/support/room.h"

using namespace boxlight;

namespace {

constexpr uint32_t kSize = 4;

struct Room : test::Room {
  using test::Room::Room;
  bool hasCells(asset::Scheme scheme = asset::Scheme::cells, uint32_t size = kSize) {
    return plan(scheme, size).front().hasCells();
  }
};

TEST(DirectionCells, AreForSharpRoundLobesAlone) {
  EXPECT_TRUE(Room(test::metal(0.3f)).hasCells());
  EXPECT_FALSE(Room(test::metal(0.33f)).hasCells()) << "alpha .11";
  EXPECT_FALSE(Room(test::lambert()).hasCells());
  EXPECT_FALSE(Room(test::metal(0.3f)).hasCells(asset::Scheme::split));
  EXPECT_FALSE(Room(test::metal(0.3f)).hasCells(asset::Scheme::sketch));
  for (const auto& extend : std::vector<void (*)(asset::MaterialExtension&)>{
           [](asset::MaterialExtension& e) { e.anisotropy = 0.5f; },
           [](asset::MaterialExtension& e) { e.clearcoat = 1; },
           [](asset::MaterialExtension& e) { e.sheenColor[0] = 1, e.sheenRoughness = 0.5f; }}) {
    Room room(test::metal(0.3f));
    extend(room.scene.materialExtensions[0]);
    EXPECT_FALSE(room.hasCells());
  }
  Room coat(test::lambert());
  coat.scene.materials[0].roughness = 0.1f, coat.scene.materialExtensions[0].clearcoat = 1;
  coat.scene.materialExtensions[0].clearcoatRoughness = 0.9f;
  EXPECT_FALSE(coat.hasCells()) << "the coat alone is glossy";
  Room glass(test::lambert());
  glass.scene.materials[0].specular = 1, glass.scene.materials[0].roughness = 0.1f;
  EXPECT_TRUE(glass.hasCells()) << "varnish";
  glass.scene.materialExtensions[0].transmission = 1;
  EXPECT_FALSE(glass.hasCells());
  Room velvet(test::metal(0.3f));  // half of its only texel
  velvet.scene.materials.push_back(test::lambert());
  velvet.scene.materialExtensions.push_back({.sheenColor = {1, 1, 1}, .sheenRoughness = 0.5f});
  velvet.scene.triangles[1].material = 2;
  EXPECT_FALSE(velvet.hasCells(asset::Scheme::cells, 1));
}

Image constantMap() {
  Image map = makeImage(32, 16, 3);
  std::fill(map.pixels.begin(), map.pixels.end(), 1.0f);
  return map;
}

class BakedCells : public ::testing::Test {
 protected:
  BakedCells() : room_(test::metal(0.2f)), records_(room_.plan(asset::Scheme::cells, kSize)) {
    baked_ = bakeScene(*room_.world, room_.map, records_, ViewSphere(2), options_, ProgressStyle::none);
  }
  const asset::Asset& asset() const { return baked_.asset; }

  Room room_;
  std::vector<RecordPlan> records_;
  KernelOptions options_{256, 8, {}, 7, 4};
  BakedScene baked_;
};

TEST_F(BakedCells, StandInStreamsOfTheirOwn) {
  EXPECT_EQ(asset().scheme, asset::Scheme::cells);
  ASSERT_EQ(asset().cellSphere.size(), 1u);
  EXPECT_EQ(asset().cellCount(), 162u);
  EXPECT_EQ(asset().streamCount(), 42u + 1 + 162);
  EXPECT_EQ(asset().visibilityMaps.size(), records_.size());
  uint64_t inViews = 0, inCells = 0;
  for (uint32_t s = 0; s < asset().streamCount(); ++s)
    if (s != asset().diffuseStream())
      (s < asset().diffuseStream() ? inViews : inCells) += uint64_t(__builtin_popcountll(asset().mask(s, 0)));
  EXPECT_EQ(inViews, 0u);
  EXPECT_GT(inCells, 20 * records_.size());
}

/// At a vertex one kernel alone speaks: what it says is what paths of other random numbers find there.
TEST_F(BakedCells, SayWhatPathsInTheirDirectionFind) {
  Relighter relighter(asset(), [&](uint32_t stream, uint32_t tile) {
    return baked_.pages[stream * asset().tiles.size() + tile];
  });
  const SummedArea white(constantMap());
  const ViewSphere cells(options_.cellFrequency);
  int hidden = 0;
  for (uint32_t r = 0; r < records_.size(); r += 3)
    for (uint32_t c = 0; c < cells.viewCount(); c += 2) {
      KernelPaths paths;
      const DirectionCell cell{cells.directions()[c], 1 - 2.0f / 162, 0.04f};
      PathTracer(*room_.world, {})
          .traceIncident(records_[r].origin(*room_.world, room_.map), cell, {99, r, c}, 1024, paths);
      if (paths.traced < 700) continue;  // more than a third of it lies below the horizon
      dvec3 exact(0.0);
      for (const Deposit& deposit : paths.deposits) exact += dvec3(deposit.throughput);
      exact /= std::max(paths.traced, 1u);
      const TexelRadiance said = relighter.arriving(r, cells.directions()[c], white);
      EXPECT_NEAR(said.hidden, double(paths.hiddenPart()), 0.1) << "record " << r << ", cell " << c;
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(said.glossy[k], exact[k], 0.1) << "record " << r << ", cell " << c;
      hidden += paths.hiddenPart() > 0.5f;
    }
  EXPECT_GT(hidden, 50);
}

}  // namespace
