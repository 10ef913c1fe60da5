// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Second half, one thread a column: the best on a CPU.
#include "sat_columns.glsl"

layout(local_size_x = kGroupSize) in;

void main() {
  uint x = gl_GlobalInvocationID.x;
  if (x > source.mapSize.x) return;
  Sum sum = zeroSum();
  store(x, 0, sum);
  for (uint y = 0; y < source.mapSize.y; ++y) {
    sum = add(sum, rowSum(x, y));
    store(x, y + 1, sum);
  }
}
