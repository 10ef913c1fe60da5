// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// First half of the summed-area table: 64-bit sums along each row, one thread a row. Integers make the result the same on
// every device; the one float operation before them is a correctly rounded product.
#include "frame.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBindLightMap) readonly buffer LightMap { float lightMap[]; };
layout(std430, binding = kBindRowFactors) readonly buffer RowFactors { float rowFactors[]; };
layout(std430, binding = kBindRowSums) writeonly buffer RowSums { RowSum rowSums[]; };

void main() {
  uint row = gl_GlobalInvocationID.x;
  if (row >= frame.lightSize.y) return;
  uvec3 low = uvec3(0), high = uvec3(0);
  for (uint x = 0; x < frame.lightSize.x; ++x) {
    uint i = row * frame.lightSize.x + x;
    precise vec3 value = vec3(lightMap[3 * i], lightMap[3 * i + 1], lightMap[3 * i + 2]) * rowFactors[row];
    precise vec3 top = floor(value * (1.0 / 4294967296.0));
    precise vec3 rest = value - top * 4294967296.0;
    uvec3 add = uvec3(rest);
    low += add;
    high += uvec3(top) + uvec3(lessThan(low, add));
    rowSums[i] = RowSum(uint[3](low.x, low.y, low.z), uint[3](high.x, high.y, high.z));
  }
}
