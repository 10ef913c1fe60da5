// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// First half, one thread a row: the best on a CPU.
#include "sat_rows.glsl"

layout(local_size_x = kGroupSize) in;

void main() {
  uint row = gl_GlobalInvocationID.x;
  if (row >= source.mapSize.y) return;
  Sum sum = zeroSum();
  for (uint x = 0; x < source.mapSize.x; ++x) {
    sum = add(sum, texelUnits(row, x));
    rowSums[row * source.mapSize.x + x] = packSum(sum);
  }
}
