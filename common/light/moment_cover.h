// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/base/math.h"

namespace boxlight {

/// The lattice of the light's moments: what a cosine box's edges may lie on in v, and twice as fine as any
/// that a bake makes.
inline constexpr uvec2 kMomentSize{256, 128};

/// How the integral of L w over a texel of that lattice is made from a light map of any size, L constant
/// inside each of its texels. With theta the angle from +Y and phi that around it,
///
///   w dw = (sin^2 theta cos phi, sin theta cos theta, sin^2 theta sin phi) dtheta dphi ,
///
/// so every component is a sum over rows of a sum over columns.
struct MomentCover {
  struct Texel {
    uint32_t first;       ///< texel of the map
    uint32_t begin, end;  ///< of the weights, one for each of the map's texels from `first`
  };
  std::vector<Texel> columns, rows;
  std::vector<vec3> columnWeights;  ///< integrals of cos phi, sin phi and 1
  std::vector<vec2> rowWeights;     ///< integrals of sin^2 theta and sin theta cos theta
};

MomentCover makeMomentCover(uvec2 mapSize);

/// The light's moments over a hemisphere are tabled for normals on a grid of the light domain,
/// kHorizonNodes.x around and kHorizonNodes.y from pole to pole, from sums over kHorizonCells that lie above
/// the horizon.
inline constexpr uvec2 kHorizonNodes{48, 25};
inline constexpr uvec2 kHorizonCells{32, 16};
inline constexpr double kHorizonBand =
    0.2;  ///< cosine of the normal up to which a cell may lie on the horizon

}  // namespace boxlight
