// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/texels.h"

// What must hold of any atlas, found without the charter's own means.

namespace boxlight::test {

/// Numbers of two triangles whose insides share a point of the atlas, in exact arithmetic, or one twice that
/// has no area there or shows its back; empty if there are none.
std::vector<uint32_t> findOverlapInAtlas(const Scene& scene);

/// The largest over triangles of |area of its footprints / area in the world - 1|.
double footprintError(const Scene& scene, const TexelMap& map);

/// Texels per metre in any direction at any place of the surface: the least and the largest singular value of
/// the map from a triangle in the world to the atlas, over its texel scale. Triangles that are lower than 64
/// atlas units of 2^-24 are left out, for they may have been widened; leftOut is their share of the surface.
struct Stretch {
  double least = 1e300, most = 0, leftOut = 0;
};
Stretch measureStretch(const Scene& scene, uint32_t atlasSize);

/// Texels of the level `coarser` (1, 2, 4) from which a bilinear filter that stands on one chart reads
/// another: it reads the 3x3 texels around, those without surface as their nearest one with. Charts are the
/// triangles that share points of both the surface and the atlas; those no longer than `crumb` texels or no
/// higher than an eighth may read each other.
uint32_t countLeaks(const Scene& scene, const TexelMap& map, double crumb, uint32_t coarser);

/// Pieces of surface that the atlas keeps together, as countLeaks sees them.
uint32_t countCharts(const Scene& scene);

}  // namespace boxlight::test
