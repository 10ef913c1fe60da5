// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_WIDE_LOBE_GLSL
#define BOXLIGHT_WIDE_LOBE_GLSL
// wide_lobe.h: lobes by cells of the light.

#include "light_tree.glsl"
#include "lobe_clip.glsl"

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

/// Lattice texels as cells of the maps: two rows at most, less than a cell or whole ones in each.
struct MapPart {
  int column, row;
  vec2 rows;           // weight of each
  float start, width;  // from the edge of the first column
};

const float kHalf = float(kMapColumns) / float(kMomentColumns);

/// `cotangent`: of the angle from +Y to its middle. Rows count by their sines.
MapPart mapPart(TreeTexels texels, float cotangent) {
  const float kTangent = 0.02454862;  // of half a row's height
  float at = kHalf * float(texels.at.x) - BOXLIGHT_LIGHT_OFFSET * float(kMapColumns), first = floor(at);
  float upper = texels.size.y > 2 ? 0.5 - 0.5 * kTangent * cotangent : 1.0;
  return MapPart(int(first) & (kMapColumns - 1), int(texels.at.y) / 2, vec2(upper, 1.0 - upper), at - first, kHalf * float(texels.size.x));
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
  uint upper = map + 4 * uint(part.row), lower = map + 4 * uint(min(part.row + 1, kMapRows - 1));
  return dot(part.rows, vec2(visibleWidth(upper, part), visibleWidth(lower, part))) / part.width;
}

bool isOpen(TreeTexels texels, FilteredMaps maps) {
  float start = kHalf * float(texels.at.x) - BOXLIGHT_LIGHT_OFFSET * float(kMapColumns), first = floor(start);
  vec2 size = kHalf * vec2(texels.size);
  Columns columns = Columns(int(first) & (kMapColumns - 1), int(ceil(start + size.x - first)), 0.0, 0.0);
  int row = int(texels.at.y) / 2;
  return (blocksOf(columns, Rows(row, row + max(int(size.y), 1), 0, 0.0, 0.0)) & maps.hiddenBlocks) == uvec4(0);
}

const float kOpen = 1.0 - 1e-5;

// Lavapipe 22.3 runs through a branch whatever the lanes want, but leaves a loop: what few lanes want is in loops of one round. All four
// maps of a level are read in it, those that are not there with a weight of 0: loops of fixed length are none when compiled, and rounds
// are few.

/// Of a root's quarters, `wide` quarters of the maps' blocks each. A map's quarter counts as even where their edges cut it; a root that is
/// open is not looked at.
vec4 visibleQuarters(TreeTexels root, FilteredMaps maps, bool open) {
  const float kQuarters = 32.0;  // around
  float start = kQuarters * (float(root.at.x) / float(kMomentColumns) - BOXLIGHT_LIGHT_OFFSET), first = floor(start), shift = start - first;
  int wide = int(root.size.x) / 16;
  vec4 visible = vec4(0.0);
  for (int i = open ? 2 * wide + 1 : 0; i <= 2 * wide; ++i) {
    vec2 column = vec2(0.0);
    for (uint four = 0; four < (kLevels ? maps.count : 1); four += 4)
      for (uint k = four; k < four + 4; ++k) {
        bool there = k < maps.count;
        column += (there ? maps.weight[k] : 0.0) * quarterColumn(maps.map[there ? k : 0], int(first) + i, int(root.at.y) / 16);
      }
    float left = float(i) - shift, width = float(wide);
    vec2 inside = clamp(min(vec2(left + 1.0), vec2(width, 2.0 * width)) - max(vec2(left), vec2(0.0, width)), 0.0, 1.0);
    visible += column.xxyy * inside.xyxy / width;
  }
  return open ? vec4(1.0) : mix(visible, vec4(1.0), greaterThanEqual(visible, vec4(kOpen)));
}

/// Of a cell with this direction in its middle, or what `known` says of the quarter of its root if that is open, hidden or the cell itself.
float visiblePart(TreeTexels texels, vec3 middle, FilteredMaps maps, float known, bool all) {
  bool found = known <= 0.0 || known >= 1.0 || all;
  float visible = found ? known : 0.0;
  for (uint once = found ? 1 : 0; once < 1; ++once) {
    MapPart part = mapPart(texels, middle.y * inversesqrt(dot(middle.xz, middle.xz)));
    for (uint four = 0; four < (kLevels ? maps.count : 1); four += 4)
      for (uint k = four; k < four + 4; ++k) {
        bool there = k < maps.count;
        visible += (there ? maps.weight[k] : 0.0) * visiblePart(maps.map[there ? k : 0], part);
      }
  }
  return visible >= kOpen ? 1.0 : max(visible, 0.0);
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
