// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_ATLAS_GLSL
#define BOXLIGHT_ATLAS_GLSL

#include "mesh.glsl"

layout(std430, binding = kBindAtlas) readonly buffer Atlas { uvec2 atlas[]; };  // records of the front and the back side

/// Where a pixel meets the surface in the atlas, and in which level its texels are as large as what the pixel sees; a part of a level
/// is a mixture of two.
struct AtlasPlace {
  vec2 uv;
  float level;
};

/// Of the point that `weight` is of. The level goes by the area that the pixel covers: by its longer side pictures are too soft where a
/// surface is seen from the side, by its shorter one they alias.
AtlasPlace atlasPlace(uvec3 vertices, vec3 weight, PlaneSteps steps) {
  AtlasPlace place = AtlasPlace(interpolate2(vertices, weight, kAtlasUvAt), 0.0);
  if (!kLevels) return place;
  vec2 size = vec2(frame.atlasSize), dx = size * interpolate2(vertices, steps.dx, kAtlasUvAt),
       dy = size * interpolate2(vertices, steps.dy, kAtlasUvAt);
  float texels = abs(determinant(mat2(dx, dy)));  // of a plane seen from its edge it may be no number
  place.level = texels > 1.0 ? min(0.5 * log2(texels), float(frame.atlasLevels - 1)) : 0.0;
  return place;
}

/// The records around an atlas position, kAbsent where there is none, and their weights, which are bilinear in a level.
struct AtlasCorners {
  uint count;
  uint record[kMaxCorners];
  float weight[kMaxCorners];
};

/// Of one level, whose texels begin at `first`, times `share`.
void addCorners(vec2 uv, bool front, ivec2 size, uint first, float share, inout AtlasCorners corners) {
  vec2 at = uv * vec2(size) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  for (int k = 0; k < 4; ++k) {
    ivec2 offset = ivec2(k & 1, k >> 1), texel = clamp(corner + offset, ivec2(0), size - 1);
    uvec2 sides = atlas[first + texel.y * size.x + texel.x];
    corners.record[corners.count] = front ? sides.x : sides.y;
    corners.weight[corners.count] = share * (offset.x == 1 ? f.x : 1.0 - f.x) * (offset.y == 1 ? f.y : 1.0 - f.y);
    ++corners.count;
  }
}

const float kLevelMixture = 0.5;  // of a level's width: elsewhere one level is enough

AtlasCorners atlasCorners(AtlasPlace place, bool front) {
  AtlasCorners corners;
  corners.count = 0;
  ivec2 size = ivec2(frame.atlasSize);
  if (!kLevels) {
    addCorners(place.uv, front, size, 0, 1.0, corners);
    return corners;
  }
  float coarser = clamp((fract(place.level) - 0.5) / kLevelMixture + 0.5, 0.0, 1.0);
  uint first = 0, level = min(uint(place.level), frame.atlasLevels - 1);
  for (uint l = 0; l < level; ++l) {
    first += size.x * size.y;
    size = max(size / 2, ivec2(1));
  }
  if (coarser < 1.0) addCorners(place.uv, front, size, first, 1.0 - coarser, corners);
  if (coarser > 0.0 && level + 1 < frame.atlasLevels) addCorners(place.uv, front, max(size / 2, ivec2(1)), first + size.x * size.y, coarser, corners);
  return corners;
}

#endif
