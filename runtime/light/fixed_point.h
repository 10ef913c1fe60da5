// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"

namespace boxlight::gpu {

/// What the summed-area table keeps of a prefix: 42 bits of each channel in 16 bytes, or 64 bits in 24.
enum class SatScheme { compact, exact };

/// How radiance becomes integers before it is summed: texel * rowFactor, truncated, is radiance times solid
/// angle in units of the table, of a compact one in units of 2^-kGuardBits of that. The factors are made once
/// on the CPU, so every device starts from the same floats. The unit is not a power of two: that costs one
/// rounding of 2^-24 and is worth up to twice the resolution.
struct FixedPoint {
  std::vector<float> rowFactors;  ///< one a row of the light map
  float unit = 1;  ///< radiance times steradian: of a compact table all light is below 2^42 - 4
};

/// `total`: radiance times steradian of the strongest channel over the whole map of `size`, or more.
FixedPoint chooseFixedPoint(double total, uvec2 size, SatScheme scheme);

/// The largest of a map's channels, as chooseFixedPoint takes it.
double strongestTotal(const Image& environment);

}  // namespace boxlight::gpu
