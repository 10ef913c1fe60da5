// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Every fragment marks the texel records that it and the layers before it will be filtered from.
#include "atlas.glsl"
#include "fragments.glsl"
#include "material_extension.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindMarks) buffer Marks { uint marks[]; };

void markRecords(AtlasCorners corners, uint mark) {
  for (uint k = 0; k < corners.count; ++k) {
    uint r = corners.record[k];
    if (r == kAbsent) continue;
    if (kOtherSide)
      atomicOr(marks[r], mark);
    else
      marks[r] = mark;
  }
}

void markTriangle(uint index, vec2 position) {
  uvec4 triangle = triangles[index];
  Plane plane = loadPlane(triangle.xyz);
  AtlasPlace place = atlasPlace(triangle.xyz, hitWeights(plane, rayDirection(position)), planeSteps(plane, position));
  bool front = seesFront(plane);
  markRecords(atlasCorners(place, front), kMarkSeen);
  if (kOtherSide && showsOtherSide(triangle.w)) markRecords(atlasCorners(place, !front), kMarkLambert);
}

void markFragment(uvec2 pixel, Fragment fragment) {
  for (uint layer = 0; layer <= kLayers; ++layer) {
    bool last = layer >= layerCount();
    uint triangle = last ? fragment.triangle : loadLayer(layer, sampleIndex(pixel, fragment.first)).x;
    if (triangle != 0) markTriangle(triangle - 1, fragment.position);
    if (last) break;
  }
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, tile.size))) return;
  uvec2 pending = allSamples();
  do {
    Fragment fragment = nextFragment(pixel, pending);
    markFragment(pixel, fragment);
  } while (pending != uvec2(0));
}
