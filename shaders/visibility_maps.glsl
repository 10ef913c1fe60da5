// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_VISIBILITY_MAPS_GLSL
#define BOXLIGHT_VISIBILITY_MAPS_GLSL

#include "lobe.glsl"

// For each record the place of its map or kAbsent, then the maps; before a map's rows the blocks that have hidden cells, and the visible
// parts of quarters of blocks.
layout(std430, binding = kBindVisibilityMaps) readonly buffer VisibilityMaps { uint visibilityMaps[]; };
layout(binding = kBindMapTexels) uniform usamplerBuffer mapTexels;

uint mapAt(uint i) { return kTexelBuffers ? texelFetch(mapTexels, int(i)).x : visibilityMaps[i]; }

bool isSplit(uint record) { return mapAt(record) != kAbsent; }

const int kMapColumns = 128, kMapRows = 64, kMostMapRows = 8;

/// What is visible of a rectangle: the part, and the smallest rectangle around it.
struct VisiblePart {
  float part;
  Rectangle around;
};

/// Cells from the first that a rectangle touches; the outer two are covered in part.
struct Columns {
  int first, count;
  float start, end;  // of the rectangle, from the edge of the first cell
};

Columns mapColumns(Rectangle rectangle) {
  float at = rectangle.u * float(kMapColumns);
  int first = int(floor(at));
  float start = at - float(first), end = start + rectangle.du * float(kMapColumns);
  return Columns(first, max(int(ceil(end)), 1), start, end);
}

/// The rows that stand for those that it touches: `step` rows each, on a grid of their own, so that they do not change with the
/// rectangle's place.
struct Rows {
  int first, end, step;
  float low, high;  // of the rectangle
};

Rows mapRows(Rectangle rectangle) {
  float low = rectangle.latitudes.v * float(kMapRows), high = (rectangle.latitudes.v + rectangle.latitudes.height) * float(kMapRows);
  int first = min(int(low), kMapRows - 1), step = max(1, int(ceil(rectangle.latitudes.height * float(kMapRows / kMostMapRows))));
  return Rows(first / step * step, clamp(int(ceil(high)), first + 1, kMapRows), step, low, high);
}

/// In a map: the word of column x of the row that stands for those from y.
uint mapWord(int y, Rows rows, int x) { return 4 * uint(min(y + rows.step / 2, kMapRows - 1)) + uint(x) / 32; }

/// Blocks of 8 x 8 cells, 16 a row, two rows a word: quickly told apart from what is visible everywhere.
const int kBlockCells = 8, kBlockColumns = kMapColumns / kBlockCells;

/// The visible parts of two quarters of blocks, one above the other, in the map whose rows begin at `map`.
vec2 quarterColumn(uint map, int column, int blockRow) {
  uint word = mapAt(map - kMapQuarterWords + 4 * uint(column & (2 * kBlockColumns - 1)) + uint(blockRow) / 2) >> 16 * (blockRow & 1);
  return vec2(word & 0xFFu, word >> 8 & 0xFFu) / 255.0;
}

/// A bit for every block that a rectangle's cells may lie in, those of skipped rows included.
uvec4 blocksOf(Columns columns, Rows rows) {
  int x = (columns.first & (kMapColumns - 1)) / kBlockCells;
  int count = (columns.first % kBlockCells + columns.count - 1) / kBlockCells + 1;
  uint ring = count >= kBlockColumns ? 0xffffu : ((1u << count) - 1) << x;
  uint across = (ring | ring >> kBlockColumns) & 0xffffu;
  int first = rows.first / kBlockCells, last = min(rows.end - 1 + rows.step, kMapRows - 1) / kBlockCells;
  ivec4 even = ivec4(0, 2, 4, 6), odd = even + 1;
  uvec4 down = uvec4(lessThanEqual(ivec4(first), even)) * uvec4(lessThanEqual(even, ivec4(last))) +
               uvec4(lessThanEqual(ivec4(first), odd)) * uvec4(lessThanEqual(odd, ivec4(last))) * 0x10000u;
  return across * down;
}

/// Of one row: cells visible, and the first and behind the last of them.
struct Run {
  float width;
  int begin, end;
};

Run scanRow(uint row, Columns columns) {
  Run run = Run(0.0, kMapColumns + 1, 0);
  for (int at = 0; at < columns.count;) {
    int x = (columns.first + at) & (kMapColumns - 1), taken = min(32 - x % 32, columns.count - at);
    uint bits = (mapAt(row + uint(x) / 32) >> (x % 32)) & (~0u >> (32 - taken));
    if (bits != 0) {
      run.begin = min(run.begin, at + findLSB(bits));
      run.end = max(run.end, at + findMSB(bits) + 1);
      run.width += float(bitCount(bits));
    }
    at += taken;
  }
  if (run.begin == 0) run.width -= columns.start;
  if (run.end == columns.count) run.width -= float(columns.count) - columns.end;
  return run;
}

/// visibility_map.h: scanVisible.
VisiblePart scanVisible(Rectangle whole, uint map) {
  Columns columns = mapColumns(whole);
  Rows rows = mapRows(whole);
  float all = 0.0, visible = 0.0, left = columns.end, right = columns.start, top = rows.high, bottom = rows.low;
  for (int y = rows.first; y < rows.end; y += rows.step) {
    float from = max(rows.low, float(y)), to = min(rows.high, float(y + rows.step)), middle = 0.5 * (from + to) / float(kMapRows);
    float weight = (to - from) * sinPi(min(middle, 1.0 - middle));
    Run run = scanRow(map + mapWord(y, rows, 0), columns);
    all += weight * (columns.end - columns.start);
    if (run.width > 0.0) {
      visible += weight * run.width;
      left = min(left, max(columns.start, float(run.begin)));
      right = max(right, min(columns.end, float(run.end)));
      top = min(top, from);
      bottom = max(bottom, to);
    }
  }
  if (!(visible > 0.0)) return VisiblePart(0.0, whole);
  float above = max(top - rows.low, 0.0) / float(kMapRows), below = max(rows.high - bottom, 0.0) / float(kMapRows);
  Latitudes kept = Latitudes(whole.latitudes.v + above, max(whole.latitudes.height - above - below, 0.0), whole.latitudes.below + below);
  float shift = (left - columns.start) / float(kMapColumns), kept_du = (right - left) / float(kMapColumns);
  return VisiblePart(min(visible / all, 1.0), Rectangle(whole.u + shift, kept_du, kept));
}

#endif
