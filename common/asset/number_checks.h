// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "common/asset/asset_format.h"

namespace boxlight::asset {

inline bool allFinite(std::span<const float> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); });
}

/// Length 1 within 1e-3: float arithmetic passes, a forgotten normalisation does not.
inline bool isUnit(std::span<const float, 3> v) {
  const double squared = double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2];
  return std::abs(squared - 1.0) <= 2e-3;
}

/// In [0,1] but for rounding.
inline bool isFraction(float number) { return number >= -1e-4f && number <= 1.0f + 1e-4f; }

/// Is it one of a sphere of views or cells (view_sphere.h)?
inline bool isFrequency(uint32_t number) { return number >= 1 && number <= kMaxViewFrequency; }

/// Vertices of the sphere of a frequency; below 2^32 for those of isFrequency.
inline uint32_t sphereVertices(uint32_t frequency) { return 10 * frequency * frequency + 2; }

}  // namespace boxlight::asset
