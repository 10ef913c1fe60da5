// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bake/scene/texels.h"

namespace boxlight {

/// Cuts the surface into the texels of coarser levels, for pixels that see several texels at once: `levels`
/// in all with the map itself, each of half the texels each way. Ends early before a level of less than
/// kLeastLevelSize texels each way, and before one in which charts bleed more than kMostBleeding (atlas.h);
/// returns why, or nothing if all are there. The map must be square.
std::string addCoarserLevels(const Scene& scene, TexelMap& map, uint32_t levels);
inline constexpr uint32_t kLeastLevelSize = 8;

}  // namespace boxlight
