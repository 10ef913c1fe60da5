// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// The light map: the mean of the environment over each texel. light_map.h has the same sums in the same order: the bits are equal.
#include "light_source.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
struct Cover {
  uint first, begin, end;
};
layout(std430, binding = kLightCovers) readonly buffer Covers { Cover covers[]; };
layout(std430, binding = kLightMap) writeonly buffer LightMap { float lightMap[]; };

/// Whole texels to a texel, as with images and maps of powers of two, ask for no table: loads are what this pass takes its time for.
Cover coverOf(uint texel, uint imageSize, uint mapSize, uint firstCover, uint firstShare) {
  uint whole = imageSize / mapSize;
  if (whole * mapSize == imageSize) return Cover(whole * texel, firstShare + whole * texel, firstShare + whole * (texel + 1));
  return covers[firstCover + texel];
}

vec3 meanOverColumns(Cover columns, uint row) {
  precise vec3 mean = vec3(0.0);
  for (uint i = columns.begin; i < columns.end; ++i)
    mean += tables[i] * imageTexel(columns.first + i - columns.begin, row);
  return mean;
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, source.mapSize))) return;
  Cover columns = coverOf(at.x, source.imageSize.x, source.mapSize.x, 0, 0);
  Cover rows = coverOf(at.y, source.imageSize.y, source.mapSize.y, source.mapSize.x, source.columnShares);
  precise vec3 mean = vec3(0.0);
  for (uint i = rows.begin; i < rows.end; ++i) mean += tables[i] * meanOverColumns(columns, rows.first + i - rows.begin);
  uint texel = 3 * (at.y * source.mapSize.x + at.x);
  for (uint c = 0; c < 3; ++c) lightMap[texel + c] = mean[c];
}
