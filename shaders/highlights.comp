// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Adds what is above the samples' ceiling to the tilted map; each texel is named once.
#include "light_source.glsl"

layout(local_size_x = kGroupSize) in;
struct Highlight {
  uint texel;
  float radiance[3];
};
layout(std430, binding = kLightHighlights) readonly buffer Highlights { Highlight highlights[]; };
layout(std430, binding = kLightMap) buffer LightMap { float lightMap[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= source.highlightCount) return;
  for (uint c = 0; c < 3; ++c) lightMap[3 * highlights[i].texel + c] += highlights[i].radiance[c];
}
