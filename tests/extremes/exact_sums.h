// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"

namespace boxlight::test {

/// A phi-theta rectangle on the grid of packed boxes, in steps of 1/65536: no float rounds its edges.
struct GridBox {
  uint32_t u = 0, v = 0, du = 1, dv = 1;
};

/// The integral of a light map over a box, green: every texel it touches, one after another, in long double.
/// Also the box's solid angle.
struct ExactSum {
  long double light = 0, solidAngle = 0;
};
ExactSum exactSum(const Image& map, const GridBox& box);

/// What fp32 would make of it: a summed-area table of floats, looked up as the shaders do theirs.
class FloatTable {
 public:
  explicit FloatTable(const Image& map);
  double texel(uint32_t x, uint32_t y) const;

 private:
  float sum(uint32_t x, uint32_t y) const { return sums_[size_t(y) * (width_ + 1) + x]; }
  uint32_t width_;
  std::vector<float> sums_;
};

}  // namespace boxlight::test
