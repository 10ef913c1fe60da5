// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_BOX_GLSL
#define BOXLIGHT_BOX_GLSL

#include "light_domain.glsl"

/// box.h.
struct Box {
  float u, du;
  Latitudes latitudes;
  vec3 energy;
};

Box unpackBox(uvec4 packed) {
  uvec2 corner = uvec2(packed.x & 0xFFFFu, packed.x >> 16), size = uvec2(packed.y & 0xFFFFu, packed.y >> 16) + 1;
  size.y = min(size.y, 65536 - corner.y);
  Latitudes latitudes = Latitudes(float(corner.y), float(size.y), float(65536 - corner.y - size.y));
  latitudes = Latitudes(latitudes.v / 65536.0, latitudes.height / 65536.0, latitudes.below / 65536.0);
  vec3 energy = vec3(unpackHalf2x16(packed.z), unpackHalf2x16(packed.w).x);
  return Box(float(corner.x) / 65536.0, float(size.x) / 65536.0, latitudes, energy);
}

/// box.h: isEmission, unpackEmission.
bool isEmission(uvec4 packed) { return packed.w >> 16 == 1; }

vec3 unpackEmission(uvec4 packed) {
  int exponent = clamp(int(packed.y & 0xFFFFu) - 32768, -126, 128);
  return ldexp(vec3(unpackHalf2x16(packed.z), unpackHalf2x16(packed.w).x), ivec3(exponent));
}

/// box.h: unpackHiddenPart.
float unpackHiddenPart(uvec4 packed) { return unpackHalf2x16(packed.z).x; }

bool isEmpty(Box box) { return all(equal(box.energy, vec3(0.0))); }

vec3 boxWeight(Box box) { return box.energy / solidAngle(box.du, box.latitudes); }

/// sin(2 pi x) and cos(2 pi x) for x in [-1/2, 1/2].
vec2 sinCosTurn(float x) {
  float half_turns = 2.0 * abs(x), s = sinPi(min(half_turns, 1.0 - half_turns));
  return vec2(x < 0.0 ? -s : s, cosPi(half_turns));
}

/// The mean of shifts on the circle, in turns; 0 where they cancel out.
float meanShift(vec3 shift, vec3 share) {
  vec2 sum = share.x * sinCosTurn(shift.x) + share.y * sinCosTurn(shift.y) + share.z * sinCosTurn(shift.z);
  if (sum == vec2(0.0)) return 0.0;
  // An atan of 1e-5, as Mesa's, would be half of a sharp box; a step of Newton's mends it.
  float mean = clamp(atan(sum.x, sum.y) / (2.0 * kPi), -0.5, 0.5);
  vec2 at = sinCosTurn(mean);
  return mean + (sum.x * at.y - sum.y * at.x) / (2.0 * kPi * length(sum));
}

/// relight.h: interpolateBoxes, whose energy becomes weights where `interpolateWeight` says so.
Box interpolateBoxes(Box a, Box b, Box c, vec3 weight, bool interpolateWeight) {
  vec3 g = weight * vec3(!isEmpty(a), !isEmpty(b), !isEmpty(c));
  float total = g.x + g.y + g.z;
  if (total <= 0.0) return Box(0.0, 1.0, Latitudes(0.0, 1.0, 0.0), vec3(0.0));
  vec3 du = vec3(a.du, b.du, c.du);
  Box result;
  result.du = min(dot(g, du) / total, 1.0);
  result.latitudes.v = dot(g, vec3(a.latitudes.v, b.latitudes.v, c.latitudes.v)) / total;
  result.latitudes.height = dot(g, vec3(a.latitudes.height, b.latitudes.height, c.latitudes.height)) / total;
  result.latitudes.below = dot(g, vec3(a.latitudes.below, b.latitudes.below, c.latitudes.below)) / total;

  vec3 centres = vec3(a.u, b.u, c.u) + 0.5 * du;
  vec3 h = g * vec3(lessThan(du, vec3(1.0)));  // a full ring has no centre
  bool centred = h.x + h.y + h.z > 0.0;
  float reference = h.x > 0.0 ? centres.x : h.y > 0.0 ? centres.y : centres.z;
  vec3 shift = centres - reference;
  shift -= floor(shift + 0.5);
  result.u = centred ? fract(reference + meanShift(shift, h) - 0.5 * result.du) : 0.0;

  result.energy = interpolateWeight
                      ? weight.x * boxWeight(a) + weight.y * boxWeight(b) + weight.z * boxWeight(c)
                      : weight.x * a.energy + weight.y * b.energy + weight.z * c.energy;
  return result;
}

#endif
