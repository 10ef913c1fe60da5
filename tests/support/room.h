// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "bake/kernels/texel_records.h"
#include "tests/support/scenes.h"

namespace boxlight::test {

/// A floor of one material, which fills the atlas, beside a coloured wall, which no texel belongs to.
struct Room {
  explicit Room(const asset::Material& floor) : scene(makeScene(floor)) {
    scene.materials.push_back(lambert(Rgb(0.9f, 0.5f, 0.2f)));
    addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    addQuad(scene, {-3, 0, -1}, {6, 0, 0}, {0, 4, 0}, vec2(2), vec2(3), 1);
    scene.materialExtensions.resize(2);
  }
  /// In an atlas of `size` texels each way.
  std::vector<RecordPlan> plan(asset::Scheme scheme, uint32_t size, bool coarseViews = false) {
    finish(scene);
    world.emplace(scene);
    map = makeTexels(scene, size, size);
    return planRecords(*world, map, scheme, coarseViews);
  }

  Scene scene;
  std::optional<Intersector> world;
  TexelMap map;
};

}  // namespace boxlight::test
