// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Second pass: whole numbers, summed along each row. What is cut off of a texel is carried on to the next, so that a row's sums are
// never wrong by more than one unit. Integers make what follows the same on every device.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTexels) readonly buffer Texels { float texels[]; };
layout(std430, binding = kMomentTable) writeonly buffer Table { uvec4 table[]; };

void main() {
  uint row = gl_GlobalInvocationID.x / 3, axis = gl_GlobalInvocationID.x % 3;
  if (row >= kMomentRows) return;
  precise vec3 carried = vec3(0.0);
  ivec3 sum = ivec3(0);
  table[momentPlace(0, row + 1, axis)] = uvec4(0);
  for (uint x = 0; x < kMomentColumns; ++x) {
    uint texel = momentTexel(x, row, axis);
    precise vec3 moment = vec3(texels[texel], texels[texel + 1], texels[texel + 2]) + carried;
    precise vec3 whole = floor(moment);
    carried = moment - whole;
    sum += ivec3(whole);
    table[momentPlace(x + 1, row + 1, axis)] = uvec4(sum, 0);
  }
}
