// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// First pass: over each texel of the lattice the integral of the light times its direction, in units of the table.
#include "moment_source.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
struct Cover {
  uint first, begin, end;
};
layout(std430, binding = kMomentCovers) readonly buffer Covers { Cover covers[]; };
layout(std430, binding = kMomentWeights) readonly buffer Weights { float weights[]; };
layout(std430, binding = kLightMap) readonly buffer LightMap { float lightMap[]; };
layout(std430, binding = kMomentTexels) writeonly buffer Texels { float texels[]; };

vec3 radianceAt(uint x, uint y) {
  uint i = 3 * (y * source.mapSize.x + x);
  return vec3(lightMap[i], lightMap[i + 1], lightMap[i + 2]);
}

void store(uvec2 at, uint axis, vec3 moment) {
  uint texel = momentTexel(at.x, at.y, axis);
  for (uint c = 0; c < 3; ++c) texels[texel + c] = moment[c] * source.perUnit;
}

/// Bright lights' moments have squares beyond floats: units first.
float square(vec3 a) {
  precise vec3 units = a * source.perUnit;
  precise float sum = units.x * units.x + units.y * units.y + units.z * units.z;
  return sum;
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, uvec2(kMomentColumns, kMomentRows)))) return;
  Cover columns = covers[at.x], rows = covers[kMomentColumns + at.y];
  precise vec3 x = vec3(0.0), y = vec3(0.0), z = vec3(0.0);
  for (uint j = rows.begin; j < rows.end; ++j) {
    precise vec3 cosines = vec3(0.0), sines = vec3(0.0), widths = vec3(0.0);
    for (uint i = columns.begin; i < columns.end; ++i) {
      vec3 radiance = radianceAt(columns.first + i - columns.begin, rows.first + j - rows.begin);
      cosines += weights[3 * i] * radiance;
      sines += weights[3 * i + 1] * radiance;
      widths += weights[3 * i + 2] * radiance;
    }
    uint row = source.rowShares + 2 * j;
    x += weights[row] * cosines;
    y += weights[row + 1] * widths;
    z += weights[row] * sines;
  }
  store(at, 0, x);
  store(at, 1, y);
  store(at, 2, z);
  texels[kMomentSquares + at.y * kMomentColumns + at.x] = square(x) + square(y) + square(z);
}
