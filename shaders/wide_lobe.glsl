// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_WIDE_LOBE_GLSL
#define BOXLIGHT_WIDE_LOBE_GLSL
// wide_lobe.h: lobes by cells of the light.

#include "light_tree.glsl"
#include "lobe_clip.glsl"

// Mesa 22.3's lavapipe ends a lane's loops after 65535 rounds of all of them: inner ones are kept short.

layout(constant_id = kConstantWide) const bool kWide = true;

// wide_lobe.h, wide_lobe.cpp
const float kWideFrom = 0.005, kWideTo = 0.01, kCellsToLobe = 1.25, kCellRadius = 0.75;
const uint kMostHiddenLevel = 3;

/// light_moments.h: LightCell; the light in units of the moments.
struct LightCell {
  Moment light;
  vec3 one;
};

LightCell loadLightCell(TreeCell at) {
  uint i = kMomentTree + 3 * treePlace(at);
  vec4 x = uintBitsToFloat(BOXLIGHT_MOMENT(i)), y = uintBitsToFloat(BOXLIGHT_MOMENT(i + 1)), z = uintBitsToFloat(BOXLIGHT_MOMENT(i + 2));
  return LightCell(Moment(x.xyz, y.xyz, z.xyz), vec3(x.w, y.w, z.w));
}

/// The lobe's density over the cosine; `axes` of the frame as the light map has it.
vec3 lobeDensity(GgxLobe lobe, mat3 axes, vec3 direction) {
  const float kLeastCosine = 1e-4;
  vec3 light = normalize(direction) * axes;
  light.z = max(light.z, kLeastCosine);
  vec3 halfVector = normalize(lobe.view + light);
  vec3 slope = vec3(halfVector.xy / lobe.alpha, halfVector.z);
  float square = dot(slope, slope), distribution = 1.0 / (kPi * lobe.alpha.x * lobe.alpha.y * square * square);
  float visibility = 0.5 / (light.z * stretchedLength(lobe.view, lobe.alpha) + lobe.view.z * stretchedLength(light, lobe.alpha));
  float grazing = clamp(1.0 - dot(lobe.view, halfVector), 0.0, 1.0), squared = grazing * grazing;
  vec3 fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * (squared * squared * grazing);
  if (kFilm && lobe.filmed) fresnel = clamp(fresnel, kLeastFilmed, 1.0);
  return distribution * visibility * fresnel;
}

/// Does the lobe vary little enough in a cell of this height around a direction of its frame?
bool resolves(GgxLobe lobe, vec3 light, float height) {
  const float kLeastCosine = 1e-4, kLeastFacing = 0.02;
  light.z = max(light.z, kLeastCosine);
  vec3 halfVector = normalize(lobe.view + light);
  float facing = max(dot(lobe.view, halfVector), kLeastFacing), reach = kCellRadius * height / (2.0 * facing);
  vec2 slope = max(abs(halfVector.xy) / halfVector.z - reach, vec2(0.0)) / lobe.alpha;
  return height <= kCellsToLobe * 2.0 * facing * min(lobe.alpha.x, lobe.alpha.y) * sqrt(1.0 + dot(slope, slope));
}

struct CellSums {
  vec3 radiance, direct, all, towards;
};

void addCellLight(Moment light, float visible, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  vec3 arriving = max(along(light, axes[2]), vec3(0.0));
  vec3 centre = vec3(strength(light.x), strength(light.y), strength(light.z));
  if (visible > 0.0 && strength(arriving) > 0.0 && dot(centre, centre) > 0.0)
    sums.radiance += visible * arriving * lobeDensity(lobe, axes, centre);
}

void addCell(LightCell cell, float visible, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  float cosine = dot(axes[2], cell.one);
  if (cosine > 0.0) {
    vec3 energy = cosine * lobeDensity(lobe, axes, cell.one);
    sums.all += energy;
    sums.direct += visible * energy;
    if (kCells) sums.towards += (1.0 - visible) * strength(energy) * normalize(cell.one);
  }
  addCellLight(cell.light, visible, lobe, axes, sums);
}

/// Lattice texels as cells of the maps: fewer than a cell in each row and column, or whole ones, four rows at most.
struct MapPart {
  int column, row;
  vec4 rows;           // weight of each
  float start, width;  // from the edge of the first column
};

MapPart mapPart(TreeTexels texels) {
  const float kHalf = float(kMapColumns) / float(kMomentColumns);
  float at = kHalf * float(texels.at.x) - BOXLIGHT_LIGHT_OFFSET * float(kMapColumns), first = floor(at);
  int row = int(texels.at.y) / 2, count = max(int(texels.size.y) / 2, 1);
  vec4 middle = (vec4(0.5, 1.5, 2.5, 3.5) + float(row)) / float(kMapRows);
  vec4 rows = vec4(lessThan(ivec4(0, 1, 2, 3), ivec4(count)));
  for (int i = 0; i < 4; ++i) rows[i] *= sinPi(min(middle[i], 1.0 - middle[i]));
  rows /= rows.x + rows.y + rows.z + rows.w;
  return MapPart(int(first) & (kMapColumns - 1), row, rows, at - first, kHalf * float(texels.size.x));
}

/// Of one row, from the first column on.
float visibleWidth(uint row, MapPart part) {
  uint x = uint(part.column), bits = mapAt(row + x / 32) >> (x % 32);
  if (x % 32 > 0) bits |= mapAt(row + (x / 32 + 1) % 4) << (32 - x % 32);
  float end = part.start + part.width;
  int last = int(ceil(end)) - 1;
  float width = float(bitCount(bits & ((2u << last) - 1)));
  return width - float(bits & 1u) * part.start - float(bits >> last & 1u) * (float(last + 1) - end);
}

float visiblePart(uint map, MapPart part) {
  vec4 widths = vec4(0.0);
  for (int i = 0; i < 4; ++i)
    if (part.rows[i] > 0.0) widths[i] = visibleWidth(map + 4 * uint(part.row + i), part);
  return dot(part.rows, widths) / part.width;
}

bool isOpen(TreeTexels texels, FilteredMaps maps) {
  const float kHalf = float(kMapColumns) / float(kMomentColumns);
  float start = kHalf * float(texels.at.x) - BOXLIGHT_LIGHT_OFFSET * float(kMapColumns), first = floor(start);
  vec2 size = kHalf * vec2(texels.size);
  Columns columns = Columns(int(first), int(ceil(start + size.x - first)), 0.0, 0.0);
  int row = int(texels.at.y) / 2;
  return (blocksOf(columns, Rows(row, row + max(int(size.y), 1), 0, 0.0, 0.0)) & maps.hiddenBlocks) == uvec4(0);
}

float visiblePart(TreeTexels texels, FilteredMaps maps) {
  const float kOpen = 1.0 - 1e-5;
  MapPart part = mapPart(texels);
  float visible = 0.0;
  for (uint k = 0; k < maps.count; ++k) visible += maps.weight[k] * visiblePart(maps.map[k], part);
  return visible >= kOpen ? 1.0 : max(visible, 0.0);
}

void addTree(uint root, GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  const float kRowHeight = kPi / float(kMomentRows);
  TreeCell at = treeRoot(root);
  bool open = isOpen(treeTexels(at), maps);
  while (!isEnd(at)) {
    LightCell cell = loadLightCell(at);
    float height = kRowHeight * float(1u << at.level);
    vec3 light = normalize(cell.one) * axes;
    bool below = light.z < -kCellRadius * height;
    bool small = at.level == 0 || ((open || at.level <= kMostHiddenLevel) && resolves(lobe, light, height));
    if (!below && small) addCell(cell, open ? 1.0 : visiblePart(treeTexels(at), maps), lobe, axes, sums);
    if (below || small)
      at = passed(at);
    else
      --at.level;
  }
}

void addBrightLight(GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  uint end = kMomentBright + 1 + 3 * BOXLIGHT_MOMENT(kMomentBright).x;
  for (uint i = kMomentBright + 1; i < end; i += 3) {
    uvec4 x = BOXLIGHT_MOMENT(i), y = BOXLIGHT_MOMENT(i + 1), z = BOXLIGHT_MOMENT(i + 2);
    TreeTexels texel = TreeTexels(uvec2(y.w, z.w), uvec2(1));
    float visible = isOpen(texel, maps) ? 1.0 : visiblePart(texel, maps);
    addCellLight(toMoment(MomentSum(x.xyz, y.xyz, z.xyz)), visible, lobe, axes, sums);
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
  float part = kWide ? clamp((min(lobe.alpha.x, lobe.alpha.y) * lobe.view.z - kWideFrom) / (kWideTo - kWideFrom), 0.0, 1.0) : 0.0;
  ClippedLobe seen = clipLobe(lobe, maps, wanted && part < 1.0);
  if (!kWide || part == 0.0 || !wanted || maps.count == 0) return seen;
  ClippedLobe cells = seeByCells(lobe, maps);
  return ClippedLobe(mix(seen.radiance, cells.radiance, part), mix(seen.hidden, cells.hidden, part), mix(seen.towards, cells.towards, part));
}

#endif
