// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Integrals of the light over rectangles, as a renderer that is not ours would ask for them (docs/integration.md).

layout(constant_id = 0) const bool kExact = false;

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Where {
  uvec2 lightSize;
  float lightUnit, lightOffset;
};
layout(std430, binding = 1) readonly buffer Compact { uvec4 compactTable[]; };
layout(std430, binding = 1) readonly buffer Exact { uvec2 exactTable[]; };

#define BOXLIGHT_LIGHT_SIZE lightSize
#define BOXLIGHT_LIGHT_UNIT lightUnit
#define BOXLIGHT_LIGHT_OFFSET lightOffset
#define BOXLIGHT_COMPACT_ENTRY(i) compactTable[i]
#define BOXLIGHT_EXACT_ENTRY(i, c) exactTable[3 * (i) + (c)]
#define BOXLIGHT_EXACT kExact
#include "boxlight.glsl"

struct Rectangle {
  float u, du, v, dv, below;
};
layout(std430, binding = 2) readonly buffer Rectangles { Rectangle rectangles[]; };
layout(std430, binding = 3) writeonly buffer Integrals { vec4 integrals[]; };  // RGB and solid angle

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= rectangles.length()) return;
  Rectangle r = rectangles[i];
  float omega;
  vec3 light = integrateLight(r.u, r.du, Latitudes(r.v, r.dv, r.below), omega);
  integrals[i] = vec4(light, omega);
}
