// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MOMENT_SOURCE_GLSL
#define BOXLIGHT_MOMENT_SOURCE_GLSL
// What the passes share that make the light's moments (kMomentColumns in shared.h, moment_cover.h on the CPU).

#include "shared.h"

layout(std430, binding = kMomentConstants) readonly buffer Constants { MomentConstants source; };

/// Of the table: entry (x, y) is the sum over what lies left of and above lattice point (x, y).
uint momentPlace(uint x, uint y, uint axis) { return 3 * (y * kMomentStride + x) + axis; }

/// Of the lattice's texels.
uint momentTexel(uint x, uint y, uint axis) { return 3 * ((axis * kMomentRows + y) * kMomentColumns + x); }

#endif
