// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/paths.h"
#include "common/light/visibility_map.h"

namespace boxlight {

/// What one side of a texel sees of the distant light: for each cell of the map, a ray from a random point of
/// the texel's surface in a random direction inside the cell. It is visible if it leaves on the surface's
/// geometric side and meets nothing.
VisibilityMap traceVisibility(const Intersector& world, const PathOrigin& origin, const StreamKey& key);

}  // namespace boxlight
