// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_ATLAS_GLSL
#define BOXLIGHT_ATLAS_GLSL

#include "mesh.glsl"

layout(std430, binding = kBindAtlas) readonly buffer Atlas { uvec2 atlas[]; };  // records of the front and the back side

/// The four records around an atlas position, kAbsent where there is none, and their bilinear weights.
struct AtlasCorners {
  uint record[4];
  float weight[4];
};

AtlasCorners atlasCorners(vec2 uv, bool front) {
  ivec2 size = ivec2(frame.atlasSize);
  vec2 at = uv * vec2(size) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  AtlasCorners corners;
  for (int k = 0; k < 4; ++k) {
    ivec2 offset = ivec2(k & 1, k >> 1), texel = clamp(corner + offset, ivec2(0), size - 1);
    uvec2 sides = atlas[texel.y * size.x + texel.x];
    corners.record[k] = front ? sides.x : sides.y;
    corners.weight[k] = (offset.x == 1 ? f.x : 1.0 - f.x) * (offset.y == 1 ? f.y : 1.0 - f.y);
  }
  return corners;
}

#endif
