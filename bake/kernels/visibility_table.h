// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/kernels/deposit_grid.h"

namespace boxlight {

/// Summed-area table of two numbers a cell, on the grid that visibility is fitted on.
class VisibilityTable {
 public:
  static constexpr int kColumns = 128, kRows = 64;
  static constexpr size_t kCells = size_t(kColumns) * kRows;

  /// `cells`: [row][column].
  void build(const std::vector<dvec2>& cells) {
    for (int y = 0; y < kRows; ++y) {
      dvec2 row(0);
      for (int x = 0; x < kColumns; ++x) {
        row += cells[size_t(y) * kColumns + x];
        sums_[size_t(y + 1) * (kColumns + 1) + x + 1] = sums_[size_t(y) * (kColumns + 1) + x + 1] + row;
      }
    }
  }

  dvec2 sum(const GridBox& box) const {
    const dvec2 right =
        box.x1 <= kColumns ? leftOf(box.x1, box) : leftOf(kColumns, box) + leftOf(box.x1 - kColumns, box);
    return right - leftOf(box.x0, box);
  }

 private:
  dvec2 leftOf(int x, const GridBox& box) const {
    return sums_[size_t(box.y1) * (kColumns + 1) + x] - sums_[size_t(box.y0) * (kColumns + 1) + x];
  }
  std::vector<dvec2> sums_ = std::vector<dvec2>(size_t(kColumns + 1) * (kRows + 1), dvec2(0));
};

}  // namespace boxlight
