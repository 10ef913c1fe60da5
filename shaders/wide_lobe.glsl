// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_WIDE_LOBE_GLSL
#define BOXLIGHT_WIDE_LOBE_GLSL
// wide_lobe.h: lobes by cells of the light.

#include "visible_cells.glsl"

// Mesa 22.3's lavapipe ends a lane's loops after 65535 rounds of all of them: inner ones are kept short.

// wide_lobe.h, wide_lobe.cpp
const float kCellsToLobe = 1.25, kCellRadius = 0.75;
const uint kMostHiddenLevel = 3;

/// light_tree.h: LightCell; the light in units of the moments.
struct LightCell {
  Moment light;
  vec3 one;
};

LightCell loadLightCell(TreeCell at) {
  uint i = kMomentTree + 3 * treePlace(at);
  vec4 x = uintBitsToFloat(BOXLIGHT_MOMENT(i)), y = uintBitsToFloat(BOXLIGHT_MOMENT(i + 1)), z = uintBitsToFloat(BOXLIGHT_MOMENT(i + 2));
  return LightCell(Moment(x.xyz, y.xyz, z.xyz), vec3(x.w, y.w, z.w));
}

/// What the lobe's density depends on in a direction of its frame.
struct LobePoint {
  vec3 halfVector;
  float facing;  // cosine between the two
};

LobePoint lobePoint(GgxLobe lobe, vec3 light) {
  const float kLeastCosine = 1e-4;
  light.z = max(light.z, kLeastCosine);
  vec3 halfVector = normalize(lobe.view + light);
  return LobePoint(halfVector, max(dot(lobe.view, halfVector), 0.0));
}

float distribution(GgxLobe lobe, vec3 halfVector) {
  vec3 slope = vec3(halfVector.xy / lobe.alpha, halfVector.z);
  float square = dot(slope, slope);
  return 1.0 / (kPi * lobe.alpha.x * lobe.alpha.y * square * square);
}

/// F G2 / (4 n.l n.v).
vec3 shadowedFresnel(GgxLobe lobe, vec3 light, LobePoint point) {
  float z = max(light.z, 0.0);
  float visibility = 0.5 / (z * stretchedLength(lobe.view, lobe.alpha) + lobe.view.z * stretchedLength(vec3(light.xy, z), lobe.alpha));
  float grazing = clamp(1.0 - point.facing, 0.0, 1.0), squared = grazing * grazing;
  vec3 fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * (squared * squared * grazing);
  if (kFilm && lobe.filmed) fresnel = clamp(fresnel, kLeastFilmed, 1.0);
  return visibility * fresnel;
}

/// Does the lobe vary little enough in a cell of this height around a point?
bool resolves(GgxLobe lobe, LobePoint point, float height) {
  const float kLeastFacing = 0.02;
  float facing = max(point.facing, kLeastFacing), reach = kCellRadius * height / (2.0 * facing);
  vec2 slope = max(abs(point.halfVector.xy) / point.halfVector.z - reach, vec2(0.0)) / lobe.alpha;
  return height <= kCellsToLobe * 2.0 * facing * min(lobe.alpha.x, lobe.alpha.y) * sqrt(1.0 + dot(slope, slope));
}

struct CellSums {
  vec3 radiance, direct, all, towards;
};

/// `shadowed`: shadowedFresnel about there.
void addLight(Moment light, float visible, vec3 shadowed, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  vec3 arriving = max(along(light, axes[2]), vec3(0.0));
  vec3 centre = vec3(strength(light.x), strength(light.y), strength(light.z));
  bool any = strength(arriving) > 0.0 && dot(centre, centre) > 0.0;
  LobePoint point = lobePoint(lobe, any ? normalize(centre) * axes : vec3(0.0, 0.0, 1.0));
  sums.radiance += any ? visible * distribution(lobe, point.halfVector) * arriving * shadowed : vec3(0.0);
}

/// A cell that the lobe resolves.
void addCell(LightCell cell, vec3 middle, vec3 light, LobePoint point, float visible, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  vec3 shadowed = shadowedFresnel(lobe, light, point);
  vec3 energy = max(dot(axes[2], cell.one), 0.0) * distribution(lobe, point.halfVector) * shadowed;
  sums.all += energy;
  sums.direct += visible * energy;
  if (kCells) sums.towards += (1.0 - visible) * strength(energy) * middle;
  addLight(cell.light, visible, shadowed, lobe, axes, sums);
}

void addTree(uint root, GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  const float kRowHeight = kPi / float(kMomentRows);
  TreeCell at = treeRoot(root);
  bool open = isOpen(treeTexels(at), maps);
  vec4 quarters = visibleQuarters(treeTexels(at), maps, open);
  while (!isEnd(at)) {
    LightCell cell = loadLightCell(at);
    float height = kRowHeight * float(1u << at.level);
    vec3 middle = normalize(cell.one), light = middle * axes;
    LobePoint point = lobePoint(lobe, light);
    bool below = light.z < -kCellRadius * height;
    bool small = below || at.level == 0 || ((open || at.level <= kMostHiddenLevel) && resolves(lobe, point, height));
    if (small && !below) {
      float visible = visiblePart(treeTexels(at), middle, maps, dot(quarters, vec4(equal(uvec4(at.leaf * 4 / kTreeLeaves), uvec4(0, 1, 2, 3)))), at.level == kMostHiddenLevel);
      addCell(cell, middle, light, point, visible, lobe, axes, sums);
    }
    TreeCell next = passed(at);
    at = small ? next : TreeCell(at.root, at.level - 1, at.leaf);
  }
}

void addBrightLight(GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  uint end = kMomentBright + 1 + 3 * BOXLIGHT_MOMENT(kMomentBright).x;
  for (uint i = kMomentBright + 1; i < end; i += 3) {
    uvec4 x = BOXLIGHT_MOMENT(i), y = BOXLIGHT_MOMENT(i + 1), z = BOXLIGHT_MOMENT(i + 2);
    TreeTexels texel = TreeTexels(uvec2(y.w, z.w), uvec2(1));
    Moment moment = toMoment(MomentSum(x.xyz, y.xyz, z.xyz));
    vec3 light = normalize(vec3(strength(moment.x), strength(moment.y), strength(moment.z))) * axes;
    if (light.z > 0.0) {
      float visible = visiblePart(texel, vec3(1.0, 0.0, 0.0), maps, isOpen(texel, maps) ? 1.0 : 0.5, false);
      addLight(moment, visible, shadowedFresnel(lobe, light, lobePoint(lobe, light)), lobe, axes, sums);
    }
  }
}

/// wide_lobe.h: seeByCells.
ClippedLobe seeByCells(GgxLobe lobe, FilteredMaps maps) {
  mat3 axes = mat3(turnedToMap(lobe.frame[0]), turnedToMap(lobe.frame[1]), turnedToMap(lobe.frame[2]));
  CellSums sums = CellSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  for (uint root = 0; root < kTreeRoots; ++root) addTree(root, lobe, axes, maps, sums);
  addBrightLight(lobe, axes, maps, sums);
  vec3 all = max(sums.all, 1e-30);
  float hidden = clamp(1.0 - strength(sums.direct / all), 0.0, 1.0);
  return ClippedLobe(BOXLIGHT_MOMENT_UNIT * sums.radiance / all, hidden, lobe.frame * (sums.towards * axes) / strength(all));
}

/// wide_lobe.h: seeLobe.
ClippedLobe seeLobe(GgxLobe lobe, FilteredMaps maps, bool wanted) {
  float part = partByCells(min(lobe.alpha.x, lobe.alpha.y), lobe.view.z);
  ClippedLobe seen = clipLobe(lobe, maps, wanted && part < 1.0);
  if (part == 0.0 || !wanted || maps.count == 0) return seen;
  ClippedLobe cells = seeByCells(lobe, maps);
  return ClippedLobe(mix(seen.radiance, cells.radiance, part), mix(seen.hidden, cells.hidden, part), mix(seen.towards, cells.towards, part));
}

#endif
