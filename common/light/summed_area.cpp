// SPDX-License-Identifier: Apache-2.0
#include "common/light/summed_area.h"

#include <array>
#include <cmath>

#include "common/light/light_domain.h"
#include "common/light/light_map.h"

namespace boxlight {

namespace {

/// Whole texels [first, last) along one axis and the part of each that a rectangle covers.
struct Span {
  uint32_t first = 0, last = 0;
  double share = 0;
};

/// Cuts [a, b], in texels, into at most three spans: a partly covered texel, whole texels, a partly covered
/// texel. Only whole texels are ever differenced in the table, and fractions multiply their sums, so that a
/// thin rectangle loses no digits. `share(i, from, to)` is the part of texel i between two positions.
template <class Share>
std::array<Span, 3> cut(double a, double b, uint32_t lastTexel, const Share& share) {
  const uint32_t first = std::min(uint32_t(a), lastTexel), last = std::min(uint32_t(b), lastTexel);
  if (first == last) return {{{first, first + 1, share(first, a, b)}}};
  return {{{first, first + 1, share(first, a, first + 1.0)},
           {first + 1, last, 1.0},
           {last, last + 1, share(last, double(last), b)}}};
}

}  // namespace

SummedArea::SummedArea(const Image& lightMap)
    : width_(lightMap.width),
      height_(lightMap.height),
      sums_(size_t(width_ + 1) * (height_ + 1), dvec3(0.0)),
      moments_(lightMap) {
  assert(lightMap.channels == 3 && width_ > 0 && height_ > 0);
  using Sum = glm::vec<3, long double>;  // the sums of a dark texel beside a sun need the digits
  const std::vector<double> solidAngles = texelSolidAngles(width_, height_);
  std::vector<Sum> above(width_ + 1, Sum(0));
  for (uint32_t y = 0; y < height_; ++y) {
    Sum row(0);
    for (uint32_t x = 0; x < width_; ++x) {
      row += Sum(rgbAt(lightMap, x, y)) * Sum(solidAngles[y]);
      above[x + 1] += row;
      sums_[size_t(y + 1) * (width_ + 1) + x + 1] = dvec3(above[x + 1]);
    }
  }
}

dvec3 SummedArea::block(uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) const {
  if (x0 >= width_) return block(x0 - width_, x1 - width_, y0, y1);
  if (x1 > width_) return block(x0, width_, y0, y1) + block(0, x1 - width_, y0, y1);
  return (sum(x1, y1) - sum(x0, y1)) - (sum(x1, y0) - sum(x0, y0));
}

dvec3 SummedArea::integrate(const Rectangle& rectangle, double uOffset) const {
  const double start = rectangle.u0 + uOffset, u0 = start - std::floor(start);
  const auto columns = cut(u0 * width_, (u0 + rectangle.du) * width_, 2 * width_ - 1,
                           [](uint32_t, double from, double to) { return to - from; });
  const auto rows = cut(rectangle.v0 * height_, (rectangle.v0 + rectangle.dv) * height_, height_ - 1,
                        [this](uint32_t y, double from, double to) {
                          return rectangleSolidAngle(1.0, from / height_, to / height_) /
                                 rectangleSolidAngle(1.0, double(y) / height_, (y + 1.0) / height_);
                        });
  dvec3 integral(0.0);
  for (const Span& row : rows)
    for (const Span& column : columns)
      if (row.share > 0.0 && column.share > 0.0 && row.first < row.last && column.first < column.last)
        integral += row.share * column.share * block(column.first, column.last, row.first, row.last);
  return integral;
}

}  // namespace boxlight
