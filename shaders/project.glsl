// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_PROJECT_GLSL
#define BOXLIGHT_PROJECT_GLSL

#include "material.glsl"
#include "tile.glsl"

/// Reversed depth without a far plane: near / distance. Lapidous and Jiao, "Optimal Depth Buffer for Low-Cost Graphics
/// Hardware", Graphics Hardware 1999; Upchurch and Desbrun, "Tightening the Precision of Perspective Rendering", JGT 2012.
vec4 project(vec3 position) {
  vec3 p = position - frame.eye.xyz;
  float w = dot(p, frame.forward.xyz);
  vec2 screen = vec2(dot(p, frame.right.xyz), -dot(p, frame.up.xyz));
  vec2 pixel = 0.5 * (screen + w) * vec2(frame.imageSize) - vec2(tile.origin) * w;
  return vec4(2.0 * pixel / vec2(tile.size) - w, frame.eye.w, w);
}

/// A corner of a triangle. One that shows the eye the back of a single-sided material, or is `hidden`, is moved out of the picture,
/// all three vertices alike.
vec4 projectCorner(uvec4 triangle, uint corner, bool hidden) {
  hidden = hidden || ((materials[triangle.w].flags & kDoubleSided) == 0 && !seesFront(loadPlane(triangle.xyz)));
  return hidden ? vec4(0.0, 0.0, 2.0, 1.0) : project(vertexPosition(triangle[corner]));
}

#endif
