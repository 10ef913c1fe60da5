// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

namespace boxlight {

/// What one path leaves on the receiver sphere. The light transport kernel is T = sum of throughput *
/// delta(direction) / pathCount; paths that do not escape leave nothing.
struct Deposit {
  vec2 uv{0.0f};         ///< escape direction in the light domain (common/light/light_domain.h)
  Rgb throughput{0.0f};  ///< finite, >= 0
  /// Of the throughput: what was reflected by microfacets and then met no other surface and no medium.
  Rgb mirrored{0.0f};
  /// Met no other surface and no medium. (Blended ones that it passed by a lottery do not count.)
  bool straight = false;

  bool operator==(const Deposit&) const = default;
};

/// Where a path set out to.
struct FirstDirection {
  vec3 towards{0.0f};     ///< unit
  bool straight = false;  ///< and met no surface and no medium there (as Deposit::straight)
};

}  // namespace boxlight
