// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_SAT_ROWS_GLSL
#define BOXLIGHT_SAT_ROWS_GLSL

#include "sat.glsl"

layout(std430, binding = kLightMap) readonly buffer LightMap { float lightMap[]; };
layout(std430, binding = kLightRowFactors) readonly buffer RowFactors { float rowFactors[]; };
layout(std430, binding = kLightRowSums) writeonly buffer RowSums { RowSum rowSums[]; };

Sum texelUnits(uint row, uint x) {
  uint i = 3 * (row * source.mapSize.x + x);
  return toUnits(vec3(lightMap[i], lightMap[i + 1], lightMap[i + 2]), rowFactors[row]);
}

#endif
