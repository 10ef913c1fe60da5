// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Opaque triangles straight from the storage buffers.
#include "project.glsl"

layout(constant_id = kConstantLayers) const uint kLayers = 0;
layout(location = 0) flat out uint triangleOut;
layout(location = 1) out vec2 weightOut;  // barycentric, of the second and third vertex

void main() {
  uint t = uint(gl_VertexIndex) / 3, corner = uint(gl_VertexIndex) % 3;
  uvec4 triangle = triangles[t];
  triangleOut = t;
  weightOut = vec2(corner == 1, corner == 2);
  bool blended = kLayers > 0 && (materials[triangle.w].flags & kAlphaBlend) != 0;
  gl_Position = projectCorner(triangle, corner, blended);
}
