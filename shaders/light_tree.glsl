// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LIGHT_TREE_GLSL
#define BOXLIGHT_LIGHT_TREE_GLSL
// light_tree.h: cells of the light in quadtrees over the lattice of its moments.

#include "shared.h"

struct TreeCell {
  uint root, level, leaf;
};

TreeCell treeRoot(uint root) { return TreeCell(root, kTreeLevels - 1, 0); }

bool isEnd(TreeCell cell) { return cell.leaf >= kTreeLeaves; }

/// To what comes after it and all that is in it.
TreeCell passed(TreeCell cell) {
  uint leaf = cell.leaf + (1u << 2 * cell.level);
  return TreeCell(cell.root, min(kTreeLevels - 1, uint(findLSB(leaf)) / 2), leaf);
}

uint treePlace(TreeCell cell) {
  uint twice = 2 * (kTreeLevels - 1 - cell.level);
  return kTreeRoots * (((1u << twice) - 1) / 3) + (cell.root << twice) + (cell.leaf >> 2 * cell.level);
}

uint evenBits(uint i) { return (i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8); }

/// Of the lattice.
struct TreeTexels {
  uvec2 at, size;
};

TreeTexels treeTexels(TreeCell cell) {
  bool above = cell.root < 12, below = cell.root >= kTreeRoots - 12;
  uint fromPole = below ? kTreeRoots - 1 - cell.root : cell.root, wide = fromPole < 4 ? 4 : above || below ? 2 : 1;
  uint row = above ? cell.root / 4 - cell.root / 8 : below ? 7 - (fromPole / 4 - fromPole / 8) : 2 + (cell.root - 12) / 16;
  uint first = above ? 4 * row : below ? kTreeRoots - 12 + 8 * (row - 6) : 12 + 16 * (row - 2);
  uvec2 inside = uvec2(evenBits(cell.leaf), evenBits(cell.leaf >> 1));
  uint rows = 1u << cell.level;
  return TreeTexels(uvec2(wide * (16 * (cell.root - first) + inside.x), 16 * row + inside.y), uvec2(wide * rows, rows));
}

#endif
