// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/image.h"

namespace boxlight {

/// What texel t of a coarser or finer grid covers along one axis: source texels first, first + 1, ... and the
/// part of t in each, `share[begin]` to `share[end - 1]`. Shares of a texel sum to 1 but for rounding.
struct AxisCover {
  struct Texel {
    uint32_t first, begin, end;
  };
  std::vector<Texel> texels;
  std::vector<float> share;
};
AxisCover coverColumns(uint32_t source, uint32_t target);  ///< by length in u
AxisCover coverRows(uint32_t source, uint32_t target);     ///< by solid angle

/// The environment that boxes are integrated against: the mean radiance over each texel of a `size`
/// equirectangular grid, the environment taken as constant inside its own texels. Exact box areas, linear in
/// u and by solid angle in v, at any ratio up or down, so the total energy, the sum of radiance times solid
/// angle, is kept to float rounding. RGB. In float, row sums first, each operation rounded by itself:
/// shaders/light_map.comp gives the same bits.
Image makeLightMap(const Image& environment, uvec2 size);

/// Steradians of a texel in each row of an equirectangular image of this size.
std::vector<double> texelSolidAngles(uint32_t width, uint32_t height);

/// Radiance times solid angle over the whole sphere, by channel.
dvec3 totalEnergy(const Image& environment);

}  // namespace boxlight
