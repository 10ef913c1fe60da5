// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_trace.h"

#include "bake/transport/surface.h"
#include "common/light/light_domain.h"

namespace boxlight {

VisibilityMap traceVisibility(const Intersector& world, const PathOrigin& origin, const StreamKey& key) {
  constexpr uint32_t kColumns = VisibilityMap::kColumns, kRows = VisibilityMap::kRows;
  VisibilityMap map;
  for (uint32_t y = 0; y < kRows; ++y)
    for (uint32_t x = 0; x < kColumns; ++x) {
      Sampler sampler(key, y * kColumns + x);
      const SurfacePoint point = sampleFootprint(origin.footprint, sampler.next2());
      const vec2 uv = (vec2(x, y) + sampler.next2()) / vec2(kColumns, kRows);
      const SurfaceView surface = viewSurfaceSide(world.scene(), point, origin.normal, origin.back);
      const vec3 direction = uvToDirection(uv);
      if (glm::dot(direction, surface.geometricNormal) > 0.0f &&
          !world.occluded(leaveSurface(world.scene(), surface, direction)))
        map.setVisible(x, y);
    }
  return map;
}

}  // namespace boxlight
