// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_VISIBLE_CELLS_GLSL
#define BOXLIGHT_VISIBLE_CELLS_GLSL
// wide_lobe.h: VisibleCells, what the maps around a pixel see of cells of the light.

#include "light_tree.glsl"
#include "lobe_clip.glsl"

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

#endif
