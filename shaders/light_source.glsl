// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LIGHT_SOURCE_GLSL
#define BOXLIGHT_LIGHT_SOURCE_GLSL

#include "shared.h"

layout(std430, binding = kLightConstants) readonly buffer Constants { LightConstants source; };
layout(std430, binding = kLightImage) readonly buffer LightImage { float lightImage[]; };
layout(std430, binding = kLightTables) readonly buffer Tables { float tables[]; };

/// A texel of the environment.
vec3 imageTexel(uint x, uint y) {
  uint i = 3 * (y * source.imageSize.x + x);
  return vec3(lightImage[i], lightImage[i + 1], lightImage[i + 2]);
}

#endif
