// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_TONE_MAP_GLSL
#define BOXLIGHT_TONE_MAP_GLSL
// common/image/tone_map.h, which says where the curves come from; tests/runtime holds the two to each other.

const uint kToneNone = 0, kToneReinhard = 1, kToneAces = 2, kToneNeutral = 3;

vec3 acesCurve(vec3 c) { return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14); }

vec3 neutralCurve(vec3 c) {
  const float reflection = 0.04, start = 0.8 - reflection, room = 1.0 - start, desaturation = 0.15;
  float darkest = min(c.x, min(c.y, c.z));
  c -= darkest < 2.0 * reflection ? darkest - 6.25 * darkest * darkest : reflection;
  float peak = max(c.x, max(c.y, c.z));
  if (peak < start) return c;
  float compressed = 1.0 - room * room / (peak + room - start);
  float white = 1.0 - 1.0 / (desaturation * (peak - compressed) + 1.0);
  return mix(c * (compressed / peak), vec3(compressed), white);
}

/// Radiance to linear display light in [0,1].
vec3 applyToneMap(uint map, vec3 radiance) {
  // NaN and negative channels become 0; comparisons with NaN are false.
  vec3 c = mix(vec3(0.0), min(radiance, 1e6), greaterThan(radiance, vec3(0.0)));
  if (map == kToneReinhard) c = c / (1.0 + c);
  if (map == kToneAces) c = acesCurve(c);
  if (map == kToneNeutral) c = neutralCurve(c);
  return min(c, 1.0);
}

/// The sRGB curve of IEC 61966-2-1 for [0,1].
vec3 encodeSrgb(vec3 linear) {
  return mix(1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

#endif
