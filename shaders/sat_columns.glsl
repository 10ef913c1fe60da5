// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_SAT_COLUMNS_GLSL
#define BOXLIGHT_SAT_COLUMNS_GLSL
// Entry (x, y) of the table is everything left of and above lattice point (x, y): of an exact one three pairs of low and high
// words, of a compact one, rounded to kPrefixBits, three low words and one word of three high parts.

#include "sat.glsl"

layout(constant_id = kConstantExactSums) const bool kExactSums = false;
layout(std430, binding = kLightRowSums) readonly buffer RowSums { RowSum rowSums[]; };
layout(std430, binding = kLightEntries) writeonly buffer CompactTable { uvec4 compactTable[]; };
layout(std430, binding = kLightEntries) writeonly buffer ExactTable { uvec2 exactTable[]; };

const uint kHighBits = kPrefixBits - 32;

uvec4 roundAndPack(Sum sum) {
  Sum rounded = add(sum, Sum(uvec3(1u << (kGuardBits - 1)), uvec3(0)));
  uvec3 kept = (rounded.low >> kGuardBits) | (rounded.high << (32 - kGuardBits));
  uvec3 top = (rounded.high >> kGuardBits) & ((1u << kHighBits) - 1u);
  return uvec4(kept, top.x | top.y << kHighBits | top.z << 2 * kHighBits);
}

void store(uint x, uint y, Sum sum) {
  uint i = y * (source.mapSize.x + 1) + x;
  if (kExactSums)
    for (uint c = 0; c < 3; ++c) exactTable[3 * i + c] = uvec2(sum.low[c], sum.high[c]);
  else
    compactTable[i] = roundAndPack(sum);
}

/// What texel row y has left of lattice column x.
Sum rowSum(uint x, uint y) { return x > 0 ? unpackSum(rowSums[y * source.mapSize.x + x - 1]) : zeroSum(); }

#endif
