// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Every fragment marks the texel records that it will be filtered from.
#include "atlas.glsl"
#include "fragments.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindMarks) writeonly buffer Marks { uint marks[]; };

void markFragment(Fragment fragment) {
  uvec3 vertices = triangles[fragment.triangle - 1].xyz;
  Plane plane = loadPlane(vertices);
  vec3 weight = hitWeights(plane, rayDirection(fragment.position));
  AtlasCorners corners = atlasCorners(interpolate2(vertices, weight, kAtlasUvAt), seesFront(plane));
  for (int k = 0; k < 4; ++k)
    if (corners.record[k] != kAbsent) marks[corners.record[k]] = 1;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, tile.size))) return;
  uvec2 pending = allSamples();
  do {
    Fragment fragment = nextFragment(pixel, pending);
    if (fragment.triangle != 0) markFragment(fragment);
  } while (pending != uvec2(0));
}
