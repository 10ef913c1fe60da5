// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_FILTER_GLSL
#define BOXLIGHT_FILTER_GLSL

#include "atlas.glsl"
#include "cells.glsl"
#include "wide_lobe.glsl"
#include "pixel_lobe.glsl"

layout(constant_id = kConstantNormalMapped) const bool kNormalMapped = true;

layout(std430, binding = kBindRecords) readonly buffer Records { GpuRecord records[]; };
layout(std430, binding = kBindMarks) readonly buffer Marks { uint marks[]; };
layout(std430, binding = kBindShaded) readonly buffer Shaded { vec4 shaded[]; };

/// Records whose hidden part depends on where the pixel's lobe points.
struct FilteredCells {
  uint count;
  uint record[kMaxCorners];
  float weight[kMaxCorners];  // among the records with split lobes
};

/// What arrives at an atlas position, demodulated: all of it from records whose lobes are whole; from the others what their hidden
/// directions send, and the maps that clip the pixel's own lobe.
struct FilteredRadiance {
  vec3 diffuse, glossy;
  float split;  // weight of the records with split lobes
  vec4 hidden;  // their mean, of those without cells: radiance, and the part that it stands for
  FilteredMaps maps;
  FilteredCells cells;
};

/// A normal that a normal map bends, on the side that is looked at; elsewhere the records' own are good enough.
struct Bend {
  bool bends;
  vec3 normal;
};

/// Of a record's diffuse radiance, for another normal than its own: to first order, so that the mean over a texel stays what the
/// bake measured there.
vec3 diffuseChange(uint r, vec3 normal) {
  vec3 change = normal - dot(normal, records[r].normal) * records[r].normal;
  return vec3(dot(shaded[gradientIndex(r, 0)].xyz, change), dot(shaded[gradientIndex(r, 1)].xyz, change),
              dot(shaded[gradientIndex(r, 2)].xyz, change));
}

void addSplit(uint r, float weight, inout FilteredRadiance sum) {
  sum.split += weight;
  if (weight <= 0.0) return;
  if (hasCells(records[r])) {
    sum.cells.record[sum.cells.count] = r;
    sum.cells.weight[sum.cells.count] = weight;
    ++sum.cells.count;
  } else {
    sum.hidden += weight * shaded[kShadedRadiances * r + 1];
  }
  uint blocks = mapAt(r);
  for (int i = 0; i < kMapBlockWords; ++i) sum.maps.hiddenBlocks[i] |= mapAt(blocks + i);
  sum.maps.map[sum.maps.count] = blocks + kMapBlockWords + kMapQuarterWords;
  sum.maps.weight[sum.maps.count] = weight;
  ++sum.maps.count;
}

/// Weights, which are sums, to means.
void normalizeFilter(float total, inout FilteredRadiance sum) {
  float scale = total > 0.0 ? 1.0 / total : 0.0;
  sum.diffuse = max(sum.diffuse * scale, 0.0);
  sum.glossy *= scale;
  if (!kSplit || sum.split <= 0.0) return;
  sum.hidden /= sum.split;
  for (uint k = 0; k < sum.maps.count; ++k) sum.maps.weight[k] /= sum.split;
  for (uint k = 0; k < sum.cells.count; ++k) sum.cells.weight[k] /= sum.split;
  sum.split *= scale;
}

/// The mean over those of the records around that were shaded. (All that exist were marked; should two shaders round a position to
/// different texels, the filter shrinks instead of reading what was never written.)
FilteredRadiance filterShaded(AtlasPlace place, bool front, bool withGlossy, Bend bend) {
  AtlasCorners corners = atlasCorners(place, front);
  FilteredRadiance sum;
  sum.diffuse = sum.glossy = vec3(0.0);
  sum.split = 0.0;
  sum.hidden = vec4(0.0);
  sum.maps.count = 0;
  sum.maps.hiddenBlocks = uvec4(0);
  sum.cells.count = 0;
  float total = 0.0;
  for (uint k = 0; k < corners.count; ++k) {
    uint r = corners.record[k];
    if (r == kAbsent || marks[r] == 0) continue;
    float weight = corners.weight[k];
    total += weight;
    sum.diffuse += weight * shaded[kShadedRadiances * r].rgb;
    if (kNormalMapped && bend.bends) sum.diffuse += weight * diffuseChange(r, bend.normal);
    if (!withGlossy) continue;
    if (kSplit && isSplit(r))
      addSplit(r, weight, sum);
    else
      sum.glossy += weight * shaded[kShadedRadiances * r + 1].rgb;
  }
  normalizeFilter(total, sum);
  return sum;
}

/// Of the records with cells: what arrives from around a direction, and the part of it that points at surfaces.
vec4 arrivingFrom(vec3 direction, FilteredCells cells) {
  ViewBlend blend = locateView(direction, frame.sphereTriangles[0], cells.count > 0 ? frame.cellTriangles : 0);
  vec4 sum = vec4(0.0);
  for (uint i = 0; i < cells.count; ++i) sum += cells.weight[i] * arrivingRadiance(records[cells.record[i]], blend);
  return sum;
}

#endif
