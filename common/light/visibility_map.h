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
  static constexpr uint32_t kColumns = 128, kRows = 64;

  bool isVisible(uint32_t x, uint32_t y) const { return words_[word(x, y)] >> (x & 31u) & 1u; }
  void setVisible(uint32_t x, uint32_t y) { words_[word(x, y)] |= 1u << (x & 31u); }

 private:
  static size_t word(uint32_t x, uint32_t y) { return size_t(y) * (kColumns / 32) + x / 32; }
  std::array<uint32_t, kColumns * kRows / 32> words_{};
};

/// A part of a rectangle, around what is visible of it.
struct VisibleRectangle {
  Rectangle rectangle;
  double visible = 0;  ///< solid angle of its visible cells inside the original rectangle
};

/// The smallest rectangle inside `whole` that has all of its visible cells; visible = 0 if there are none.
VisibleRectangle shrinkToVisible(const Rectangle& whole, const VisibilityMap& map);

}  // namespace boxlight
