// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_HORIZON_GLSL
#define BOXLIGHT_HORIZON_GLSL

/// view_sphere.h: raiseAboveHorizon, for directions that are not exactly opposite to the normal.
vec3 raiseAboveHorizon(vec3 direction, vec3 normal, float cosine) {
  float current = dot(direction, normal);
  if (current >= cosine) return direction;
  vec3 along = direction - current * normal;
  along /= max(length(along), 1e-6);
  return normalize(cosine * normal + sqrt(1.0 - cosine * cosine) * along);
}

#endif
