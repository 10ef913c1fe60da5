// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"

namespace boxlight::gpu {

/// How radiance becomes integers before it is summed: texel * rowFactor, truncated, is radiance times solid
/// angle in units of `unit` / 2^kGuardBits. The factors are made once on the CPU, so every device starts from
/// the same floats.
struct FixedPoint {
  std::vector<float> rowFactors;  ///< one a row of the light map
  float unit = 1;  ///< a power of two: the strongest channel of the whole map is below 2^41 units
};

/// `lightMap`: RGB, finite, not negative.
FixedPoint chooseFixedPoint(const Image& lightMap);

}  // namespace boxlight::gpu
