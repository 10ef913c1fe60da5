// SPDX-License-Identifier: Apache-2.0
// Which records have fewer views, and that the kernels in their streams are those of their own sphere.
#include <gtest/gtest.h>

#include <bit>

#include "bake/kernels/scene_bake.h"
#include "common/light/relight.h"
#include "tests/support/room.h"

using namespace boxlight;

namespace {

struct Room : test::Room {
  using test::Room::Room;
  uint32_t sphere(asset::Scheme scheme = asset::Scheme::split, bool coarseViews = true) {
    return plan(scheme, 1, coarseViews).front().viewSphere();
  }
};

/// A metal of this GGX alpha.
asset::Material metalOfAlpha(float alpha) { return test::metal(std::sqrt(alpha)); }

TEST(CoarseViews, GoByRoughness) {
  EXPECT_EQ(Room(metalOfAlpha(0.14f)).sphere(), 0u);
  EXPECT_EQ(Room(metalOfAlpha(0.16f)).sphere(), 1u);
  EXPECT_EQ(Room(metalOfAlpha(0.34f)).sphere(), 1u);
  EXPECT_EQ(Room(metalOfAlpha(0.36f)).sphere(), 2u);
  EXPECT_EQ(Room(metalOfAlpha(0.36f)).sphere(asset::Scheme::cells), 2u);
  EXPECT_EQ(Room(metalOfAlpha(0.09f)).sphere(asset::Scheme::cells), 0u);
  EXPECT_EQ(Room(metalOfAlpha(0.36f)).sphere(asset::Scheme::sketch), 0u) << "kernels hold the lobe";
  EXPECT_EQ(Room(metalOfAlpha(0.36f)).sphere(asset::Scheme::split, false), 0u) << "not asked for";
  EXPECT_EQ(Room(test::lambert()).sphere(), 0u) << "no gloss";
}

TEST(CoarseViews, AreForLobesThatAreAllMirroredAndRough) {
  for (const auto& [what, extend] : std::vector<std::pair<const char*, void (*)(asset::MaterialExtension&)>>{
           {"sharp coat", [](asset::MaterialExtension& e) { e.clearcoat = 1, e.clearcoatRoughness = 0.2f; }},
           {"sheen", [](asset::MaterialExtension& e) { e.sheenColor[0] = 1, e.sheenRoughness = 0.5f; }}}) {
    Room room(metalOfAlpha(0.36f));
    extend(room.scene.materialExtensions[0]);
    EXPECT_EQ(room.sphere(), 0u) << what;
  }
  Room coated(metalOfAlpha(0.36f));
  coated.scene.materialExtensions[0].clearcoat = 1;
  coated.scene.materialExtensions[0].clearcoatRoughness = std::sqrt(0.2f);
  EXPECT_EQ(coated.sphere(), 1u) << "by the coat, which is the sharper one";
  Room brushed(metalOfAlpha(0.2f));
  brushed.scene.materialExtensions[0].anisotropy = 0.9f;
  EXPECT_EQ(brushed.sphere(), 1u) << "by the sharper axis";
  Room glass(test::lambert());
  glass.scene.materials[0].specular = 1, glass.scene.materials[0].roughness = 0.7f;
  EXPECT_EQ(glass.sphere(), 2u) << "varnish";
  glass.scene.materialExtensions[0].transmission = 1;
  EXPECT_EQ(glass.sphere(), 0u);
  Room half(metalOfAlpha(0.36f));
  half.scene.materials.push_back(metalOfAlpha(0.04f));
  half.scene.materialExtensions.emplace_back();
  half.scene.triangles[1].material = 2;
  EXPECT_EQ(half.sphere(), 0u) << "by the sharper half of the texel";
}

Image constantMap() {
  Image map = makeImage(32, 16, 3);
  std::fill(map.pixels.begin(), map.pixels.end(), 1.0f);
  return map;
}

/// By alpha: 42 views or 12.
class BakedCoarseViews : public ::testing::TestWithParam<float> {
 protected:
  BakedCoarseViews()
      : room_(metalOfAlpha(GetParam())),
        records_(room_.plan(asset::Scheme::split, 3, true)),
        baked_(bakeScene(*room_.world, room_.map, records_, ViewSphere(3), options_, ProgressStyle::none)),
        sphere_(GetParam() < 0.35f ? 2 : 1) {}
  const asset::Asset& asset() const { return baked_.asset; }

  Room room_;
  std::vector<RecordPlan> records_;
  KernelOptions options_{1024, 8, {}, 7};
  BakedScene baked_;
  ViewSphere sphere_;
};

TEST_P(BakedCoarseViews, StandInTheFirstStreams) {
  ASSERT_EQ(asset().coarseViews.size(), sphere_.frequency() == 2 ? 1u : 2u);
  EXPECT_EQ(asset().coarseViews.back().count, sphere_.viewCount());
  EXPECT_EQ(asset().streamCount(), 93u);
  int kernels = 0;
  for (uint32_t s = 0; s < 92; ++s) {
    const int here = std::popcount(asset().mask(s, 0));
    if (s >= sphere_.viewCount()) {
      EXPECT_EQ(here, 0) << s;
    }
    kernels += here;
  }
  EXPECT_GT(kernels, int(sphere_.viewCount()));
}

/// At a vertex one kernel alone speaks: what it says is what paths of other random numbers find there.
TEST_P(BakedCoarseViews, SayWhatPathsFindAtTheirDirections) {
  Relighter relighter(asset(), [&](uint32_t stream, uint32_t tile) {
    return baked_.pages[stream * asset().tiles.size() + tile];
  });
  const SummedArea white(constantMap());
  int compared = 0;
  for (uint32_t r = 0; r < records_.size(); ++r)
    for (uint32_t v = 0; v < sphere_.viewCount(); ++v) {
      const PathOrigin origin = records_[r].origin(*room_.world, room_.map);
      const vec3 view = sphere_.directions()[v];
      if (glm::dot(view, origin.normal) < 0.1f) continue;
      KernelPaths paths;
      PathTracer(*room_.world, {}).traceGlossy(origin, view, {99, r, v}, 4096, paths);
      const double part = paths.hiddenPart();
      if (part < 2 * double(KernelOptions::kLeastHiddenPart)) continue;
      paths.removeMirrored();
      dvec3 exact(0.0);
      for (const Deposit& deposit : paths.deposits) exact += dvec3(deposit.throughput) / double(paths.traced);
      const vec3 eye = vec3(records_[r].record.position[0], records_[r].record.position[1],
                            records_[r].record.position[2]) +
                       1000.0f * view;
      const TexelRadiance said = relighter.relight(r, eye, white);
      EXPECT_NEAR(said.hidden, part, 0.05) << "record " << r << ", view " << v;
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(said.glossy[k], exact[k], 0.05) << "record " << r << ", view " << v;
      ++compared;
    }
  EXPECT_GT(compared, int(sphere_.viewCount()) / 2);
}

INSTANTIATE_TEST_SUITE_P(Alpha, BakedCoarseViews, ::testing::Values(0.2f, 0.5f),
                         [](const auto& test) { return test.param < 0.35f ? "views42" : "views12"; });

}  // namespace
