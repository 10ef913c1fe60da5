// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/image.h"

namespace boxlight {

/// The environment that boxes are integrated against: the mean radiance over each texel of a `size`
/// equirectangular grid, the environment taken as constant inside its own texels. Exact box areas, linear in
/// u and by solid angle in v, at any ratio up or down, so the total energy, the sum of radiance times solid
/// angle, is kept to float rounding. RGB.
Image makeLightMap(const Image& environment, uvec2 size);

/// Steradians of a texel in each row of an equirectangular image of this size.
std::vector<double> texelSolidAngles(uint32_t width, uint32_t height);

}  // namespace boxlight
