// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Fifth pass: the moments of the cells that hemispheres are made of, without the bright texels. A cell's w, the moment of a light of 1,
// stays.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTable) readonly buffer Table { uvec4 table[]; };
layout(std430, binding = kMomentCells) buffer Cells { vec4 cells[]; };

const uvec2 kCellTexels = uvec2(kMomentColumns / kHorizonCellColumns, kMomentRows / kHorizonCellRows);

void main() {
  uint cell = gl_GlobalInvocationID.x / 3, axis = gl_GlobalInvocationID.x % 3;
  if (cell >= kHorizonCellCount) return;
  uvec2 from = uvec2(cell % kHorizonCellColumns, cell / kHorizonCellColumns) * kCellTexels, to = from + kCellTexels;
  uvec3 sum = table[momentPlace(to.x, to.y, axis)].xyz - table[momentPlace(from.x, to.y, axis)].xyz -
              (table[momentPlace(to.x, from.y, axis)].xyz - table[momentPlace(from.x, from.y, axis)].xyz);
  for (uint bright = kMomentBright + 1; bright < kMomentBright + 1 + 3 * table[kMomentBright].x; bright += 3)
    if (table[bright].w == cell) sum -= table[bright + axis].xyz;
  cells[3 * cell + axis].xyz = vec3(ivec3(sum));
}
