// SPDX-License-Identifier: Apache-2.0
#include "common/light/visibility_map.h"

#include <algorithm>
#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// What the cells [first, last) overlap of [low, high], all in cells.
struct Span {
  double low, high;
  int first, last;

  Span(double start, double size, uint32_t cells)
      : low(start * cells),
        high((start + size) * cells),
        first(int(std::floor(low))),
        last(int(std::ceil(high))) {}
  double from(int i) const { return std::max(low, double(i)); }
  double to(int i) const { return std::min(high, double(i) + 1); }
};

}  // namespace

VisibleRectangle shrinkToVisible(const Rectangle& whole, const VisibilityMap& map) {
  constexpr int kColumns = int(VisibilityMap::kColumns), kRows = int(VisibilityMap::kRows);
  const Span across(whole.u0, whole.du, VisibilityMap::kColumns),
      down(whole.v0, whole.dv, VisibilityMap::kRows);
  double left = across.high, right = across.low, top = down.high, bottom = down.low, visible = 0;
  for (int y = std::max(down.first, 0); y < std::min(down.last, kRows); ++y) {
    double columns = 0;
    for (int x = across.first; x < across.last; ++x) {
      if (!map.isVisible(uint32_t((x % kColumns + kColumns) % kColumns), uint32_t(y))) continue;
      columns += across.to(x) - across.from(x);
      left = std::min(left, across.from(x)), right = std::max(right, across.to(x));
    }
    if (columns <= 0) continue;
    visible += rectangleSolidAngle(columns / kColumns, down.from(y) / kRows, down.to(y) / kRows);
    top = std::min(top, down.from(y)), bottom = std::max(bottom, down.to(y));
  }
  if (visible <= 0) return {};
  return {{left / kColumns, top / kRows, (right - left) / kColumns, (bottom - top) / kRows}, visible};
}

}  // namespace boxlight
