// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/scene.h"

namespace boxlight {

/// Texels per metre, the square root of a triangle's area in the atlas over its area in the world, divided by
/// its texel scale. `least` and `most` leave out one hundredth of the surface each: the figures of a set of
/// UVs are those of its surface, not of its worst sliver.
struct TexelDensity {
  double least = 0, mean = 0, most = 0;
  double coverage = 0;  ///< area of all triangles in the atlas, of the whole atlas
};

/// Of Vertex::atlasUv in an atlas of atlasSize x atlasSize texels.
TexelDensity measureDensity(const Scene& scene, uint32_t atlasSize);

}  // namespace boxlight
