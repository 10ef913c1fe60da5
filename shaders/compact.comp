// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Marks to a list. Its order is not defined, and nothing depends on it.
#include "frame.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBindMarks) readonly buffer Marks { uint marks[]; };
layout(std430, binding = kBindVisible) buffer Visible {
  VisibleHeader header;
  uint visible[];
};

shared uint groupCount, groupStart;

void main() {
  uint r = gl_GlobalInvocationID.x;
  if (gl_LocalInvocationID.x == 0) groupCount = 0;
  barrier();
  uint mark = r < frame.recordCount ? marks[r] : 0;
  uint place = mark != 0 ? atomicAdd(groupCount, 1) : 0;
  barrier();
  if (gl_LocalInvocationID.x == 0 && groupCount > 0) {
    groupStart = atomicAdd(header.count, groupCount);
    atomicMax(header.groups[0], (groupStart + groupCount + kGroupSize - 1) / kGroupSize);
  }
  if (r == 0) header.groups[1] = header.groups[2] = 1;
  barrier();
  if (mark != 0) visible[groupStart + place] = mark == kMarkLambert ? r | kLambertOnly : r;
}
