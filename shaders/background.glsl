// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_BACKGROUND_GLSL
#define BOXLIGHT_BACKGROUND_GLSL

#include "light_domain.glsl"

layout(std430, binding = kBindBackground) readonly buffer Background { float background[]; };

vec3 backgroundTexel(int x, int y) {
  ivec2 size = ivec2(frame.backgroundSize);
  x = x < 0 ? x + size.x : x >= size.x ? x - size.x : x;
  int i = 3 * (clamp(y, 0, size.y - 1) * size.x + x);
  return vec3(background[i], background[i + 1], background[i + 2]);
}

/// environment.h: sampleEnvironment, turned.
vec3 backgroundRadiance(vec3 direction) {
  vec4 turned[3] = frame.toEnvironment;
  vec2 uv = directionToUv(normalize(turned[0].xyz * direction.x + turned[1].xyz * direction.y + turned[2].xyz * direction.z));
  vec2 at = uv * vec2(frame.backgroundSize) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  vec3 top = mix(backgroundTexel(corner.x, corner.y), backgroundTexel(corner.x + 1, corner.y), f.x);
  vec3 bottom = mix(backgroundTexel(corner.x, corner.y + 1), backgroundTexel(corner.x + 1, corner.y + 1), f.x);
  return frame.lightIntensity * mix(top, bottom, f.y);
}

#endif
