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

shared uint brightCount, bright[kBrightTexels];  // of those in the tree, their places

void findBright(TreeTexels whole) {
  brightCount = 0;
  uint end = kMomentBright + 1 + 3 * table[kMomentBright].x;
  for (uint i = kMomentBright + 1; i < end; i += 3) {
    uvec2 texel = uvec2(table[i + 1].w, table[i + 2].w) - whole.at;  // large if it lies before
    if (all(lessThan(texel, whole.size))) bright[brightCount++] = i;
  }
}

bool isBright(uvec2 texel) {
  bool found = false;
  for (uint i = 0; i < brightCount; ++i) found = found || texel == uvec2(table[bright[i] + 1].w, table[bright[i] + 2].w);
  return found;
}

/// From the texels themselves: beside a sun whole numbers would leave little of what is dark.
vec3 leafMoment(TreeTexels leaf, uint axis) {
  vec3 sum = vec3(0.0);
  for (uint x = leaf.at.x; x < leaf.at.x + leaf.size.x; ++x) {
    uint texel = momentTexel(x, leaf.at.y, axis);
    if (!isBright(uvec2(x, leaf.at.y))) sum += vec3(texels[texel], texels[texel + 1], texels[texel + 2]);
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
  TreeTexels whole = treeTexels(treeRoot(gl_WorkGroupID.x));
  if (gl_LocalInvocationID.x == 0) findBright(whole);
  barrier();
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
