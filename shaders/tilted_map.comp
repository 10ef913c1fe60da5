// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// The light map of a tilted environment: the mean of samples, each read in the texel that contains it. environment_tilt.h has the same
// operations in the same order, and the inexact functions only guess: the bits are equal.
#include "light_source.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kLightMap) writeonly buffer LightMap { float lightMap[]; };

const float kPi = 3.14159265358979;
const int kTiltCorrections = 16;  // environment_tilt.cpp

// Places in the tables: environment_tilt.h.
uint rowsAt() { return 2 * source.mapSize.x * source.samplesPerAxis; }
uint columnEdgesAt() { return rowsAt() + 2 * source.mapSize.y * source.samplesPerAxis; }
uint rowEdgesAt() { return columnEdgesAt() + 2 * source.imageSize.x; }
vec2 pair(uint at) { return vec2(tables[at], tables[at + 1]); }

uint findRow(float y) {
  int last = int(source.imageSize.y) - 1;
  uint edges = rowEdgesAt();
  int row = clamp(int(acos(clamp(y, -1.0, 1.0)) / kPi * float(last + 1)), 0, last);
  while (row > 0 && y > tables[edges + row]) --row;
  while (row < last && y <= tables[edges + row + 1]) ++row;
  return uint(row);
}

bool isPast(uint edge, float x, float z) {
  vec2 e = pair(columnEdgesAt() + 2 * edge);
  precise float side = e.x * z - e.y * x;
  return side >= 0.0;
}

uint findColumn(float x, float z) {
  int count = int(source.imageSize.x);
  float phi = x == 0.0 && z == 0.0 ? 0.0 : atan(z, x);
  int column = clamp(int((0.5 + phi / (2.0 * kPi)) * float(count)), 0, count - 1);
  for (int k = 0; k < kTiltCorrections && !isPast(uint(column), x, z); ++k) column = (column + count - 1) % count;
  for (int k = 0; k < kTiltCorrections && isPast(uint((column + 1) % count), x, z); ++k) column = (column + 1) % count;
  return uint(column);
}

vec3 sampleRadiance(vec2 column, vec2 row) {
  precise vec3 d = vec3(row.y * column.x, row.x, row.y * column.y);
  precise vec3 e = (source.toImage[0].xyz * d.x + source.toImage[1].xyz * d.y) + source.toImage[2].xyz * d.z;
  return min(imageTexel(findColumn(e.x, e.z), findRow(e.y)), source.ceiling.rgb);
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, source.mapSize))) return;
  uint n = source.samplesPerAxis;
  precise vec3 sum = vec3(0.0);
  for (uint j = 0; j < n; ++j) {
    vec2 row = pair(rowsAt() + 2 * (at.y * n + j));
    precise vec3 rowSum = vec3(0.0);
    for (uint i = 0; i < n; ++i) rowSum += sampleRadiance(pair(2 * (at.x * n + i)), row);
    sum += rowSum;
  }
  precise vec3 mean = sum * (1.0 / float(n * n));
  uint texel = 3 * (at.y * source.mapSize.x + at.x);
  for (uint c = 0; c < 3; ++c) lightMap[texel + c] = mean[c];
}
