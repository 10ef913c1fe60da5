// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/atlas_levels.h"

#include "bake/scene/atlas.h"
#include "bake/scene/bleeding.h"

namespace boxlight {

void addCoarserLevels(const Scene& scene, TexelMap& map, uint32_t levels) {
  for (uint32_t level = 1; level < levels; ++level) {
    const uint32_t size = map.width >> level;
    if (size < kLeastLevelSize || measureBleeding(scene, size) > kMostBleeding) return;
    map.coarser.push_back(makeTexels(scene, size, size));
  }
}

}  // namespace boxlight
