// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LIGHT_DOMAIN_GLSL
#define BOXLIGHT_LIGHT_DOMAIN_GLSL

#include "frame.glsl"

/// sin(pi x) for x in [0, 1/2] to a relative 2e-7, also at 0: Taylor series. Vulkan promises no more than 2^-11 of its own sin,
/// of which nothing would be left for a box at a pole.
float sinPi(float x) {
  float a = kPi * x, s = a * a;
  float series = 1.0 / 362880.0 - s * (1.0 / 39916800.0);
  series = 1.0 / 5040.0 - s * series;
  series = 1.0 / 120.0 - s * series;
  series = 1.0 / 6.0 - s * series;
  return a - a * s * series;
}

/// The extent of a rectangle in v: upper edge, height, and what is left below the lower edge. The three sum to 1; the last is kept
/// because 1 - v - height would have no digits near the south pole.
struct Latitudes {
  float v, height, below;
};

/// cos(pi v) - cos(pi (v + height)) as a product, which keeps its digits for thin rectangles and at both poles.
float cosineDifference(Latitudes l) {
  return 2.0 * sinPi(min(min(l.v, l.below) + 0.5 * l.height, 0.5)) * sinPi(0.5 * l.height);
}

/// Steradians.
float solidAngle(float du, Latitudes l) { return 2.0 * kPi * du * cosineDifference(l); }

float cosPi(float x) { return x <= 0.5 ? sinPi(0.5 - x) : -sinPi(x - 0.5); }  // x in [0, 1]

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
