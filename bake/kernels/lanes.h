// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

namespace boxlight {

/// Four floats that travel together in one SSE register: R, G, B of an integral and, in the last lane, its
/// noise.
using Lanes [[gnu::vector_size(16)]] = float;

inline Lanes splat(float value) { return Lanes{value, value, value, value}; }
inline Lanes lanes(Rgb c, float last) { return Lanes{c.x, c.y, c.z, last}; }
inline Lanes maxLanes(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes minLanes(Lanes a, Lanes b) { return a < b ? a : b; }
inline float sumLanes(Lanes a) { return (a[0] + a[2]) + (a[1] + a[3]); }

}  // namespace boxlight
