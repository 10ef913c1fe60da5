// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Blended triangles, by their list.
#include "project.glsl"

layout(std430, binding = kBindBlended) readonly buffer Blended { uint blended[]; };
layout(location = 0) flat out uint triangleOut;

void main() {
  uint t = blended[uint(gl_VertexIndex) / 3], corner = uint(gl_VertexIndex) % 3;
  triangleOut = t;
  gl_Position = projectCorner(triangles[t], corner, false);
}
