// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LIGHT_DOMAIN_GLSL
#define BOXLIGHT_LIGHT_DOMAIN_GLSL

#include "light.glsl"

/// light_domain.h: meanDirection.
vec3 meanDirection(float u, float du, Latitudes l) {
  float extent = 0.5 * kPi * l.height, s = sinPi(0.5 * l.height), c = cosPi(0.5 * l.height);
  float excess = extent < 0.05 ? 2.0 / 3.0 * extent * extent * extent : extent - s * c;
  float middle = sinPi(min(min(l.v, l.below) + 0.5 * l.height, 0.5));
  float ring = 2.0 * sinPi(0.5 * du) * cosPi(0.5 * du) / (kPi * du) * (middle * c + excess / (2.0 * middle * s));
  float phi = 2.0 * kPi * (fract(u + 0.5 * du) - 0.5);
  return vec3(ring * cos(phi), cosPi(l.v + 0.5 * l.height) * c, ring * sin(phi));
}

/// light_domain.h: directionToUv.
vec2 directionToUv(vec3 d) {
  float u = 0.5 + atan(d.z, d.x) / (2.0 * kPi);
  return vec2(u >= 1.0 ? u - 1.0 : u, atan(length(d.xz), d.y) / kPi);
}

#endif
