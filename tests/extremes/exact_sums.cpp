// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/exact_sums.h"

#include <cmath>
#include <numbers>

#include "common/light/light_map.h"

namespace boxlight::test {
namespace {

constexpr long double kPiLong = std::numbers::pi_v<long double>;
constexpr uint64_t kGrid = 65536;

/// cos(pi a) - cos(pi b) as a product.
long double cosines(long double a, long double b) {
  return 2 * std::sin(kPiLong * (a + b) / 2) * std::sin(kPiLong * (b - a) / 2);
}

/// Overlap of grid interval [a, a + size] with texel i of n, in units of 1 / (grid * n).
uint64_t overlap(uint64_t a, uint64_t size, uint64_t i, uint64_t n) {
  const uint64_t low = std::max(a * n, i * kGrid), high = std::min((a + size) * n, (i + 1) * kGrid);
  return high > low ? high - low : 0;
}

}  // namespace

ExactSum exactSum(const Image& map, const GridBox& box) {
  const uint64_t w = map.width, h = map.height;
  std::vector<std::pair<uint32_t, long double>> columns;  // texel and its part of u
  for (uint64_t x = box.u * w / kGrid; x * kGrid < (uint64_t(box.u) + box.du) * w; ++x)
    columns.emplace_back(uint32_t(x % w),
                         (long double)(overlap(box.u, box.du, x, w)) / (long double)(kGrid * w));
  ExactSum sum;
  for (uint64_t y = box.v * h / kGrid; y < h && y * kGrid < (uint64_t(box.v) + box.dv) * h; ++y) {
    const uint64_t low = std::max(box.v * h, y * kGrid),
                   high = std::min((box.v + box.dv) * h, (y + 1) * kGrid);
    const long double units = (long double)(kGrid * h);
    const long double height = cosines((long double)(low) / units, (long double)(high) / units);
    long double row = 0;
    for (const auto& [x, part] : columns) row += part * (long double)(map.at(x, uint32_t(y))[1]);
    sum.light += 2 * kPiLong * height * row;
  }
  const long double v0 = (long double)(box.v) / kGrid, v1 = (long double)(box.v + box.dv) / kGrid;
  sum.solidAngle = 2 * kPiLong * ((long double)(box.du) / kGrid) * cosines(v0, v1);
  return sum;
}

FloatTable::FloatTable(const Image& map)
    : width_(map.width), sums_(size_t(map.width + 1) * (map.height + 1), 0.0f) {
  const auto solidAngles = texelSolidAngles(map.width, map.height);
  for (uint32_t y = 0; y < map.height; ++y) {
    float row = 0;
    for (uint32_t x = 0; x < width_; ++x) {
      row += map.at(x, y)[1] * float(solidAngles[y]);
      sums_[size_t(y + 1) * (width_ + 1) + x + 1] = sum(x + 1, y) + row;
    }
  }
}

double FloatTable::texel(uint32_t x, uint32_t y) const {
  return double((sum(x + 1, y + 1) - sum(x, y + 1)) - (sum(x + 1, y) - sum(x, y)));
}

}  // namespace boxlight::test
