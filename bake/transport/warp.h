// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "common/base/math.h"

// Directions of the upper hemisphere (z up) from random numbers of [0,1)^2.

namespace boxlight {

/// Density z / pi.
inline vec3 cosineDirection(vec2 random) {
  const float radius = std::sqrt(random.x), phi = 2.0f * kPi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0f, 1.0f - random.x))};
}

inline constexpr float kUniformHemisphereDensity = 0.5f / kPi;
inline vec3 uniformDirection(vec2 random) {
  const float z = random.x, radius = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = 2.0f * kPi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

/// Uniform over the cap of directions whose z is at least `cosine`.
inline vec3 capDirection(vec2 random, float cosine) {
  const float z = 1.0f - random.x * (1.0f - cosine), radius = std::sqrt(std::max(0.0f, 1.0f - z * z)),
              phi = 2.0f * kPi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

}  // namespace boxlight
