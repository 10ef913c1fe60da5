// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Fifth pass: the moments of the cells that hemispheres are made of, without the bright texels. A cell's w, the moment of a light of 1, stays.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTable) readonly buffer Table { uvec4 table[]; };
layout(std430, binding = kMomentCells) buffer Cells { vec4 cells[]; };

void main() {
  uint cell = gl_GlobalInvocationID.x / 3, axis = gl_GlobalInvocationID.x % 3;
  if (cell >= kHorizonCellCount) return;
  uvec2 size = uvec2(kMomentColumns / kHorizonCellColumns, kMomentRows / kHorizonCellRows);
  uvec2 from = uvec2(cell % kHorizonCellColumns, cell / kHorizonCellColumns) * size, to = from + size;
  uvec3 sum = table[momentPlace(to.x, to.y, axis)].xyz - table[momentPlace(from.x, to.y, axis)].xyz -
              (table[momentPlace(to.x, from.y, axis)].xyz - table[momentPlace(from.x, from.y, axis)].xyz);
  for (uint bright = kMomentBright + 1; bright < kMomentBright + 1 + 3 * table[kMomentBright].x; bright += 3)
    if (table[bright].w == cell) sum -= table[bright + axis].xyz;
  cells[gl_GlobalInvocationID.x].xyz = vec3(ivec3(sum));
}
