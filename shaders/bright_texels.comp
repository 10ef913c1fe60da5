// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Fourth pass, of one workgroup: the lattice's brightest texels (bright_texels.h), as table entries behind the nodes. The lattice is left
// without them.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTexels) buffer Texels { float texels[]; };
layout(std430, binding = kMomentTable) buffer Table { uvec4 table[]; };

const uint kBins = 256, kShare = kMomentColumns * kMomentRows / kGroupSize;
shared uint counts[kBins], found[kGroupSize], leastBin;

/// Of lattice texel `i`; kBins for what is too faint.
uint binOf(uint i) {
  float ratio = texels[kMomentSquares + i] / source.leastSquare;
  return ratio < 1.0 ? kBins : min((floatBitsToUint(ratio) - floatBitsToUint(1.0)) >> 20, kBins - 1);
}

void findLeastBin() {
  uint sum = 0, least = kBins;
  while (least > 0 && sum + counts[least - 1] <= kBrightTexels) sum += counts[--least];
  leastBin = least;
  table[kMomentBright] = uvec4(sum, 0, 0, 0);
}

void store(uint place, uint i) {
  uint x = i % kMomentColumns, y = i / kMomentColumns;
  uvec2 size = uvec2(kMomentColumns / kHorizonCellColumns, kMomentRows / kHorizonCellRows);
  for (uint axis = 0; axis < 3; ++axis) {
    uvec3 sum = table[momentPlace(x + 1, y + 1, axis)].xyz - table[momentPlace(x, y + 1, axis)].xyz -
                (table[momentPlace(x + 1, y, axis)].xyz - table[momentPlace(x, y, axis)].xyz);
    for (uint c = 0; c < 3; ++c) texels[momentTexel(x, y, axis) + c] = 0.0;
    table[kMomentBright + 1 + 3 * place + axis] = uvec4(sum, axis == 0 ? y / size.y * kHorizonCellColumns + x / size.x : axis == 1 ? x : y);
  }
}

void main() {
  uint me = gl_LocalInvocationID.x, begin = me * kShare, end = begin + kShare;
  for (uint bin = me; bin < kBins; bin += kGroupSize) counts[bin] = 0;
  barrier();
  for (uint i = begin; i < end; ++i)
    if (binOf(i) < kBins) atomicAdd(counts[binOf(i)], 1);
  barrier();
  if (me == 0) findLeastBin();
  barrier();
  found[me] = 0;
  for (uint i = begin; i < end; ++i)
    if (binOf(i) < kBins && binOf(i) >= leastBin) ++found[me];
  barrier();
  uint place = 0;
  for (uint other = 0; other < me; ++other) place += found[other];
  for (uint i = begin; i < end && found[me] > 0; ++i)
    if (binOf(i) < kBins && binOf(i) >= leastBin) store(place++, i);
}
