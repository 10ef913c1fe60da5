// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Second half: sums down each column of the rows' sums, rounded to kPrefixBits and packed as three low words and one word of
// three high parts. Entry (x, y) is everything left of and above lattice point (x, y).
#include "frame.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBindRowSums) readonly buffer RowSums { RowSum rowSums[]; };
layout(std430, binding = kBindSummedArea) writeonly buffer SummedArea { uvec4 summedArea[]; };

const uint kHighBits = kPrefixBits - 32;

uvec4 roundAndPack(uvec3 low, uvec3 high) {
  uvec3 rounded = low + (1u << (kGuardBits - 1));
  high += uvec3(lessThan(rounded, low));
  uvec3 kept = (rounded >> kGuardBits) | (high << (32 - kGuardBits));
  uvec3 top = (high >> kGuardBits) & ((1u << kHighBits) - 1u);
  return uvec4(kept, top.x | top.y << kHighBits | top.z << 2 * kHighBits);
}

void main() {
  uint x = gl_GlobalInvocationID.x, stride = frame.lightSize.x + 1;
  if (x >= stride) return;
  summedArea[x] = uvec4(0);
  uvec3 low = uvec3(0), high = uvec3(0);
  for (uint y = 0; y < frame.lightSize.y; ++y) {
    if (x > 0) {
      RowSum sum = rowSums[y * frame.lightSize.x + x - 1];
      uvec3 add = uvec3(sum.low[0], sum.low[1], sum.low[2]);
      low += add;
      high += uvec3(sum.high[0], sum.high[1], sum.high[2]) + uvec3(lessThan(low, add));
    }
    summedArea[(y + 1) * stride + x] = roundAndPack(low, high);
  }
}
