// SPDX-License-Identifier: Apache-2.0
// What kernels of split lobes are given for what is hidden: how many boxes, and in which views.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/kernels/texel_bake.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

RecordPlan planOf(uint32_t flags, uint32_t unmirrored) {
  RecordPlan plan{};
  plan.record.flags = flags;
  plan.glossyLobes = 1 + unmirrored, plan.unmirrored = unmirrored;
  return plan;
}

TEST(HiddenKernels, HaveThreeEighthsOfTheBoxesAndHalfInCells) {
  const uint32_t split = asset::kSplitLobe, cells = asset::kSplitLobe | asset::kDirectionCells;
  const KernelOptions eight{.boxes = 8};
  EXPECT_EQ(eight.glossySlots(planOf(split, 0)), 1u + 3);
  EXPECT_EQ(eight.glossySlots(planOf(cells, 0)), 1u + 4);
  EXPECT_EQ(eight.glossySlots(planOf(split, 1)), 1u + 3 + 8);
  EXPECT_EQ(eight.glossySlots(planOf(split, 3)), 1u + 3 + 16);
  EXPECT_EQ(eight.glossySlots(planOf(0, 0)), 8u);
  EXPECT_EQ(KernelOptions{.boxes = 1}.hiddenBoxes(false), 1u);
  EXPECT_EQ(KernelOptions{.boxes = 64}.hiddenBoxes(false), 24u);
  EXPECT_EQ(KernelOptions{.boxes = 64}.glossySlots(planOf(split, 1)), 64u);
}

/// A rough mirror beside a wall that sends `emission` of its own.
class MirrorBesideAWall {
 public:
  explicit MirrorBesideAWall(float emission) : scene_(test::makeScene(test::metal(0.4f))) {
    asset::Material wall = test::lambert(Rgb(0.5f));
    scene_.materialExtensions.resize(2);
    for (float& channel : scene_.materialExtensions[1].emissive) channel = emission;
    scene_.materials.push_back(wall);
    test::addQuad(scene_, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    test::addQuad(scene_, {-1, 0, -2}, {2, 0, 0}, {0, 1, 0}, vec2(2), vec2(3), 1);  // no texel belongs to it
    test::finish(scene_);
    world_.emplace(scene_);
    map_ = makeTexels(scene_, 1, 1);
    plan_ = planRecords(*world_, map_, asset::Scheme::split).front();
    kernels_ = TexelBaker(*world_, map_, sphere_, options_).bake(plan_, options_.glossySlots(plan_));
  }

  /// Of all views that meet anything but distant light; a negative one has no kernel.
  std::vector<float> hiddenParts() {
    std::vector<float> parts;
    TexelBaker baker(*world_, map_, sphere_, options_);
    for (uint32_t view = 0; view < kernels_.glossy.size(); ++view) {
      if (sphere_.directions()[view].y < 0.05f) continue;
      const float part = baker.retrace(plan_, view).hiddenPart();
      if (part > 0.0f) parts.push_back(kernels_.glossy[view].slots.empty() ? -part : part);
    }
    return parts;
  }

 private:
  Scene scene_;
  std::optional<Intersector> world_;
  TexelMap map_;
  ViewSphere sphere_{3};
  KernelOptions options_{.paths = 1024};
  RecordPlan plan_;
  RecordKernels kernels_;
};

TEST(HiddenKernels, AreLeftOutWhereNextToNothingIsHidden) {
  int left = 0, stored = 0;
  for (const float part : MirrorBesideAWall(0).hiddenParts()) {
    EXPECT_EQ(part < 0, std::abs(part) < KernelOptions::kLeastHiddenPart) << part;
    ++(part < 0 ? left : stored);
  }
  EXPECT_GT(left, 3);
  EXPECT_GT(stored, 3);
}

TEST(HiddenKernels, AreKeptWhereAnEmitterIsSeen) {
  int kept = 0;
  for (const float part : MirrorBesideAWall(1).hiddenParts())
    kept += part > 0 && part < KernelOptions::kLeastHiddenPart;
  EXPECT_GT(kept, 3);
}

}  // namespace
