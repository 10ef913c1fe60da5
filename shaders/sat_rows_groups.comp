// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// First half, one workgroup a row: neighbouring threads read neighbouring texels, and scan kGroupSize of them at a time (Hillis and
// Steele, "Data Parallel Algorithms", CACM 29(12), 1986).
#include "sat_rows.glsl"

layout(local_size_x = kGroupSize) in;
shared Sum scanned[kGroupSize];

void main() {
  uint row = gl_WorkGroupID.x, lane = gl_LocalInvocationID.x;
  Sum before = zeroSum();
  for (uint first = 0; first < source.mapSize.x; first += kGroupSize) {
    uint x = first + lane;
    Sum sum = zeroSum();
    if (x < source.mapSize.x) sum = texelUnits(row, x);
    scanned[lane] = sum;
    barrier();
    for (uint reach = 1; reach < kGroupSize; reach *= 2) {
      if (lane >= reach) sum = add(sum, scanned[lane - reach]);
      barrier();
      scanned[lane] = sum;
      barrier();
    }
    if (x < source.mapSize.x) rowSums[row * source.mapSize.x + x] = packSum(add(before, sum));
    before = add(before, scanned[kGroupSize - 1]);
    barrier();
  }
}
