// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/atlas_levels.h"

#include <cassert>

#include "bake/scene/atlas.h"
#include "bake/scene/bleeding.h"
#include "common/base/error.h"

namespace boxlight {

std::string addCoarserLevels(const Scene& scene, TexelMap& map, uint32_t levels) {
  assert(map.width == map.height);
  for (uint32_t level = 1; level < levels; ++level) {
    const uint32_t size = map.width >> level;
    if (size < kLeastLevelSize) return fmt::format("level {} would have {} texels each way", level, size);
    if (const double bleeding = measureBleeding(scene, size); bleeding > kMostBleeding)
      return fmt::format("in level {} charts would bleed into each other by {:.1f} %", level, 100 * bleeding);
    map.coarser.push_back(makeTexels(scene, size, size));
  }
  return {};
}

}  // namespace boxlight
