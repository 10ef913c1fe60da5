// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/light/summed_area.h"

namespace boxlight {

/// From where light reaches a texel straight: one bit for each cell of a regular grid over the light domain.
/// It depends neither on the view nor on the material.
class VisibilityMap {
 public:
  static constexpr uint32_t kColumns = 128, kRows = 64, kCells = kColumns * kRows;
  using Row = std::array<uint32_t, kColumns / 32>;  ///< the lowest bit is the leftmost cell

  bool isVisible(uint32_t x, uint32_t y) const { return rows_[y][x / 32] >> (x & 31u) & 1u; }
  void setVisible(uint32_t x, uint32_t y) { rows_[y][x / 32] |= 1u << (x & 31u); }
  const Row& row(uint32_t y) const { return rows_[y]; }

  bool operator==(const VisibilityMap&) const = default;

 private:
  std::array<Row, kRows> rows_{};
};

/// What is visible of a rectangle.
struct VisiblePart {
  double part = 0;   ///< of its solid angle, 0 to 1
  Rectangle around;  ///< the smallest rectangle inside that has all of its visible cells; 0 if there are none
};

/// Cells at the rectangle's edges count by as much as it covers of them. Of a rectangle higher than 8 rows,
/// every second (third, ...) of the map stands for the others.
VisiblePart scanVisible(const Rectangle& whole, const VisibilityMap& map);

}  // namespace boxlight
