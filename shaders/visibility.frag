// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Which triangle a sample sees. Everything else about the point is found again from the ray.
#include "material.glsl"

layout(constant_id = kConstantMasked) const bool kMasked = true;
layout(location = 0) flat in uint triangleIn;
layout(location = 1) in vec2 weightIn;
layout(location = 0) out uint sampleOut;

void main() {
  if (kMasked) {
    uvec4 triangle = triangles[triangleIn];
    Material material = materials[triangle.w];
    vec3 weight = vec3(1.0 - weightIn.x - weightIn.y, weightIn);
    if ((material.flags & kAlphaMask) != 0 && sampleAlpha(material, triangle.xyz, weight) < material.alphaCutoff) discard;
  }
  sampleOut = triangleIn + 1;
}
