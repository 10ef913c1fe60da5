// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Third pass: the sums of rows, summed down each column.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTable) buffer Table { uvec4 table[]; };

void main() {
  uint column = gl_GlobalInvocationID.x / 3, axis = gl_GlobalInvocationID.x % 3;
  if (column >= kMomentStride) return;
  uvec4 sum = uvec4(0);
  table[momentPlace(column, 0, axis)] = sum;
  for (uint y = 1; y <= kMomentRows; ++y) {
    sum += table[momentPlace(column, y, axis)];
    table[momentPlace(column, y, axis)] = sum;
  }
}
