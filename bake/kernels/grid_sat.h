// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/kernels/deposit_grid.h"

namespace boxlight {

/// Summed-area table over the cells of a grid. Boxes may wrap.
class GridSat {
 public:
  /// cellAt(x, y) is called once per cell, row by row from the left.
  template <class CellAt>
  void build(int columns, int rows, const CellAt& cellAt) {
    columns_ = columns;
    stride_ = columns + 1;
    sums_.resize(size_t(stride_) * (rows + 1));
    std::fill_n(sums_.begin(), stride_, splat(0.0f));
    for (int y = 0; y < rows; ++y) {
      const Lanes* above = row(y) + 1;
      Lanes* below = &sums_[size_t(y + 1) * stride_];
      Lanes sum = splat(0.0f);
      *below++ = sum;
      for (int x = 0; x < columns; ++x) below[x] = above[x] + (sum += cellAt(x, y));
    }
  }
  /// [0, columns]: sums over what lies above line y and left of each column line.
  const Lanes* row(int y) const { return &sums_[size_t(y) * stride_]; }
  Lanes sum(const GridBox& box) const {
    const Lanes *top = row(box.y0), *bottom = row(box.y1);
    const auto leftOf = [&](int x) { return bottom[x] - top[x]; };
    if (box.x1 <= columns_) return leftOf(box.x1) - leftOf(box.x0);
    return leftOf(columns_) - leftOf(box.x0) + leftOf(box.x1 - columns_);
  }

 private:
  int columns_ = 0, stride_ = 0;
  std::vector<Lanes> sums_;
};

}  // namespace boxlight
