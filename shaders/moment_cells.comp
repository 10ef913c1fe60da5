// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Fifth pass: the moments of the cells that hemispheres are made of and of blocks of them, without the bright texels. A cell's w, the
// moment of a light of 1, stays.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTable) buffer Table { uvec4 table[]; };
layout(std430, binding = kMomentCells) buffer Cells { vec4 cells[]; };

/// Over cells of `size` lattice texels.
uvec3 momentOver(uvec2 at, uvec2 size, uint axis) {
  uvec2 from = at * size, to = from + size;
  return table[momentPlace(to.x, to.y, axis)].xyz - table[momentPlace(from.x, to.y, axis)].xyz -
         (table[momentPlace(to.x, from.y, axis)].xyz - table[momentPlace(from.x, from.y, axis)].xyz);
}

const uvec2 kCellTexels = uvec2(kMomentColumns / kHorizonCellColumns, kMomentRows / kHorizonCellRows);

void makeCell(uint cell, uint axis) {
  uint place = 3 * cell + axis;
  uvec3 sum = momentOver(uvec2(cell % kHorizonCellColumns, cell / kHorizonCellColumns), kCellTexels, axis);
  for (uint bright = kMomentBright + 1; bright < kMomentBright + 1 + 3 * table[kMomentBright].x; bright += 3)
    if (table[bright].w == cell) sum -= table[bright + axis].xyz;
  cells[place].xyz = vec3(ivec3(sum));
  table[kMomentLightCells + place] = floatBitsToUint(cells[place]);
}

void makeBlock(uint block, uint axis) {
  const uint kBlockColumns = kHorizonCellColumns / 2;
  uvec2 at = uvec2(block % kBlockColumns, block / kBlockColumns);
  float one = 0.0;
  uvec3 sum = momentOver(at, 2 * kCellTexels, axis);
  for (uint bright = kMomentBright + 1; bright < kMomentBright + 1 + 3 * table[kMomentBright].x; bright += 3) {
    uvec2 cell = uvec2(table[bright].w % kHorizonCellColumns, table[bright].w / kHorizonCellColumns);
    if (cell / 2 == at) sum -= table[bright + axis].xyz;
  }
  for (uint k = 0; k < 4; ++k) {
    uvec2 cell = 2 * at + uvec2(k & 1, k >> 1);
    one += cells[3 * (cell.y * kHorizonCellColumns + cell.x) + axis].w;
  }
  table[kMomentBlocks + 3 * block + axis] = floatBitsToUint(vec4(vec3(ivec3(sum)), one));
}

void main() {
  uint i = gl_GlobalInvocationID.x / 3, axis = gl_GlobalInvocationID.x % 3;
  if (i < kHorizonCellCount)
    makeCell(i, axis);
  else if (i < kHorizonCellCount + kHorizonCellCount / 4)
    makeBlock(i - kHorizonCellCount, axis);
}
