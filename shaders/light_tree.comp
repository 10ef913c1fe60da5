// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Last pass, a workgroup for each tree: the light's moments in its cells, without the bright texels. What stands in the table as w, the
// moments of a light of 1, stays.
#include "light_tree.glsl"
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentTexels) readonly buffer Texels { float texels[]; };
layout(std430, binding = kMomentTable) coherent buffer Table { uvec4 table[]; };

/// From the texels themselves: beside a sun whole numbers would leave little of what is dark.
vec3 leafMoment(TreeTexels leaf, uint axis) {
  vec3 sum = vec3(0.0);
  for (uint x = leaf.at.x; x < leaf.at.x + leaf.size.x; ++x) {
    uint texel = momentTexel(x, leaf.at.y, axis);
    sum += vec3(texels[texel], texels[texel + 1], texels[texel + 2]);
  }
  return sum;
}

vec3 sumOfChildren(TreeCell cell, uint axis) {
  vec3 sum = vec3(0.0);
  for (uint k = 0; k < 4; ++k) {
    uint level = cell.level - 1;
    sum += uintBitsToFloat(table[kMomentTree + 3 * treePlace(TreeCell(cell.root, level, cell.leaf + (k << 2 * level))) + axis].xyz);
  }
  return sum;
}

void main() {
  for (uint level = 0; level < kTreeLevels; ++level) {
    uint count = 3 * (kTreeLeaves >> 2 * level);
    for (uint i = gl_LocalInvocationID.x; i < count; i += kGroupSize) {
      TreeCell cell = TreeCell(gl_WorkGroupID.x, level, i / 3 << 2 * level);
      uint axis = i % 3;
      vec3 sum = level == 0 ? leafMoment(treeTexels(cell), axis) : sumOfChildren(cell, axis);
      table[kMomentTree + 3 * treePlace(cell) + axis].xyz = floatBitsToUint(sum);
    }
    memoryBarrierBuffer();
    barrier();
  }
}
