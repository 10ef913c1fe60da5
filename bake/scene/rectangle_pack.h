// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/base/math.h"

namespace boxlight {

struct PackedRectangle {
  ivec2 size, corner;
};

/// Places rectangles in a square of `side`; false if they do not all fit. The same rectangles give the same
/// places.
bool packRectangles(std::vector<PackedRectangle>& rectangles, int side);

}  // namespace boxlight
