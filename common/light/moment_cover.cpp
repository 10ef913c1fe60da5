// SPDX-License-Identifier: Apache-2.0
#include "common/light/moment_cover.h"

#include <cmath>

namespace boxlight {
namespace {

/// Cuts `target` equal parts at the edges of `source` equal parts; `weigh(from, to)` of both in [0, 1].
template <class Weigh>
void cover(uint32_t source, uint32_t target, std::vector<MomentCover::Texel>& texels, const Weigh& weigh) {
  const double units = double(source) * target;
  uint32_t place = 0;
  for (uint64_t t = 0; t < target; ++t) {
    const uint64_t begin = t * source, end = begin + source, first = begin / target;
    MomentCover::Texel texel{uint32_t(first), place, place};
    for (uint64_t s = first; s * target < end; ++s, ++texel.end)
      weigh(double(std::max(begin, s * target)) / units, double(std::min(end, (s + 1) * target)) / units);
    place = texel.end;
    texels.push_back(texel);
  }
}

/// sin b - sin a as a product, which keeps its digits.
double sineDifference(double a, double b) { return 2.0 * std::cos(0.5 * (a + b)) * std::sin(0.5 * (b - a)); }

}  // namespace

MomentCover makeMomentCover(uvec2 mapSize) {
  MomentCover result;
  cover(mapSize.x, kMomentSize.x, result.columns, [&](double from, double to) {
    const double a = 2.0 * kPiDouble * (from - 0.5), b = 2.0 * kPiDouble * (to - 0.5);
    const double sine = 2.0 * std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a));
    result.columnWeights.emplace_back(dvec3(sineDifference(a, b), sine, b - a));
  });
  cover(mapSize.y, kMomentSize.y, result.rows, [&](double from, double to) {
    const double a = kPiDouble * from, b = kPiDouble * to, size = b - a;
    result.rowWeights.emplace_back(
        dvec2(0.5 * (size - std::cos(a + b) * std::sin(size)), 0.5 * std::sin(a + b) * std::sin(size)));
  });
  return result;
}

}  // namespace boxlight
