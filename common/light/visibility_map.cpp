// SPDX-License-Identifier: Apache-2.0
#include "common/light/visibility_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kColumns = int(VisibilityMap::kColumns), kRows = int(VisibilityMap::kRows), kMostRows = 8;

/// Cells from the first that the rectangle touches; the outer two are covered in part.
struct Columns {
  int first, count;
  double start, end;  // of the rectangle, from the edge of the first cell

  Columns(double u0, double du) : first(int(std::floor(u0 * kColumns))) {
    start = u0 * kColumns - first;
    end = start + du * kColumns;
    count = std::max(int(std::ceil(end)), 1);
  }
};

/// Of one row: cells visible, and the first and behind the last of them.
struct Run {
  double width = 0;
  int begin = kColumns + 1, end = 0;
};

Run scanRow(const VisibilityMap::Row& row, const Columns& columns) {
  Run run;
  for (int at = 0; at < columns.count;) {
    const int x = (columns.first + at) & (kColumns - 1), taken = std::min(32 - x % 32, columns.count - at);
    const uint32_t bits = (row[size_t(x / 32)] >> (x % 32)) & (~0u >> (32 - taken));
    if (bits != 0) {
      run.begin = std::min(run.begin, at + std::countr_zero(bits));
      run.end = std::max(run.end, at + 32 - std::countl_zero(bits));
      run.width += std::popcount(bits);
    }
    at += taken;
  }
  if (run.begin == 0) run.width -= columns.start;
  if (run.end == columns.count) run.width -= columns.count - columns.end;
  return run;
}

}  // namespace

VisiblePart scanVisible(const Rectangle& whole, const VisibilityMap& map) {
  const Columns columns(whole.u0, whole.du);
  const double low = whole.v0 * kRows, high = (whole.v0 + whole.dv) * kRows;
  const int first = std::min(int(low), kRows - 1), last = std::clamp(int(std::ceil(high)), first + 1, kRows);
  // By size, and on a grid of their own: rows that change with the place would make the part jump.
  const int step = std::max(1, int(std::ceil(whole.dv * kRows / kMostRows)));
  double all = 0, visible = 0, left = columns.end, right = columns.start, top = high, bottom = low;
  for (int y = first / step * step; y < last; y += step) {
    const double from = std::max(low, double(y)), to = std::min(high, double(y + step));
    const double weight = (to - from) * std::sin(kPiDouble / kRows * 0.5 * (from + to));
    const Run run = scanRow(map.row(uint32_t(std::min(y + step / 2, kRows - 1))), columns);
    all += weight * (columns.end - columns.start);
    if (!(run.width > 0)) continue;
    visible += weight * run.width;
    left = std::min(left, std::max(columns.start, double(run.begin)));
    right = std::max(right, std::min(columns.end, double(run.end)));
    top = std::min(top, from), bottom = std::max(bottom, to);
  }
  if (!(visible > 0)) return {};
  return {
      std::min(visible / all, 1.0),
      {(columns.first + left) / kColumns, top / kRows, (right - left) / kColumns, (bottom - top) / kRows}};
}

}  // namespace boxlight
