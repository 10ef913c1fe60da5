// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "common/light/light_domain.h"
#include "common/light/moment_cover.h"

namespace boxlight {

/// A cell of the light domain.
struct LightCell {
  dmat3 light{0.0};  ///< int L w dw, one column a channel
  dvec3 one{0.0};    ///< that of a light of 1
};

/// Quadtrees over the lattice of kMomentSize: roots of 16 rows (22.5 degrees) and, so that cells are about as
/// wide as high, of 16 columns times 4 next to the poles, 2 beside those and 1 elsewhere; leaves of one row.
inline constexpr uint32_t kTreeRoots = 88, kTreeLevels = 5, kTreeLeaves = 256;
inline constexpr uint32_t kTreeCells = kTreeRoots * 341;  ///< of all levels

/// A walk through one of the trees, parents before children, children row by row.
struct TreeCell {
  uint32_t root, level = kTreeLevels - 1;  ///< 0: a leaf
  uint32_t leaf = 0;                       ///< the first in it, in the order of the walk
  bool isEnd() const { return leaf >= kTreeLeaves; }
  void enter() { --level; }
  void pass();  ///< to what comes after it and all that is in it
  uint32_t rows() const { return 1u << level; }
  uint32_t place() const;  ///< among kTreeCells
  /// Of the lattice: first column and row, columns and rows.
  struct Texels {
    uvec2 at, size;
  };
  Texels texels() const;
};

/// The rectangle of lattice texels in the world, of a light that is turned by uOffset (environmentOffset).
Rectangle rectangleOf(TreeCell::Texels texels, double uOffset);

/// What a light sends through each of the cells.
class LightTree {
 public:
  LightTree() = default;
  /// `moment`: of the lattice's texels.
  explicit LightTree(const std::function<dmat3(uint32_t x, uint32_t y)>& moment);
  LightCell cell(const TreeCell& at) const;

 private:
  std::vector<dmat3> light_;
};

/// Of a light of 1, in the light map's directions: int w dw over lattice texels, and for all cells.
dvec3 momentOfOne(TreeCell::Texels texels);
const std::vector<dvec3>& momentsOfOne();

}  // namespace boxlight
