// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Triangles straight from the storage buffers. A triangle that shows the eye the back of a single-sided material is moved out of
// the picture, all three vertices alike.
#include "material.glsl"

layout(push_constant) uniform Push { ImageTile tile; };
layout(location = 0) flat out uint triangleOut;
layout(location = 1) out vec2 weightOut;  // barycentric, of the second and third vertex

/// Reversed depth without a far plane: near / distance. Lapidous and Jiao, "Optimal Depth Buffer for Low-Cost Graphics
/// Hardware", Graphics Hardware 1999; Upchurch and Desbrun, "Tightening the Precision of Perspective Rendering", JGT 2012.
vec4 project(vec3 position) {
  vec3 p = position - frame.eye.xyz;
  float w = dot(p, frame.forward.xyz);
  vec2 screen = vec2(dot(p, frame.right.xyz), -dot(p, frame.up.xyz));
  vec2 pixel = 0.5 * (screen + w) * vec2(frame.imageSize) - vec2(tile.origin) * w;
  return vec4(2.0 * pixel / vec2(tile.size) - w, frame.eye.w, w);
}

void main() {
  uint t = uint(gl_VertexIndex) / 3, corner = uint(gl_VertexIndex) % 3;
  uvec4 triangle = triangles[t];
  triangleOut = t;
  weightOut = vec2(corner == 1, corner == 2);
  bool hidden = (materials[triangle.w].flags & kDoubleSided) == 0 && !seesFront(loadPlane(triangle.xyz));
  gl_Position = hidden ? vec4(0.0, 0.0, 2.0, 1.0) : project(vertexPosition(triangle[corner]));
}
