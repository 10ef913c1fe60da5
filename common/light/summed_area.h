// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"
#include "common/light/box.h"
#include "common/light/light_moments.h"

namespace boxlight {

inline Rectangle rectangleOf(const Box& box) { return {box.u0, box.v0, box.du, box.dv}; }

/// Integrals of a light map over rectangles, in double precision from a summed-area table. The map is
/// constant inside its texels, so fractional edges are linear in phi and, across a row, in cos(theta): a
/// constant map gives the rectangle's solid angle exactly (Crow, "Summed-Area Tables for Texture Mapping",
/// SIGGRAPH 1984, on the sphere).
class SummedArea {
 public:
  /// `lightMap`: RGB, finite.
  explicit SummedArea(const Image& lightMap);

  /// Integral of radiance over the rectangle moved by uOffset (environmentOffset). Radiance times steradian.
  dvec3 integrate(const Rectangle& rectangle, double uOffset = 0.0) const;
  dvec3 integrate(const Box& box, double uOffset) const { return integrate(rectangleOf(box), uOffset); }

  /// Integrals of the same light times its direction.
  const LightMoments& moments() const { return moments_; }

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }

 private:
  /// Integral over the texels of columns [x0, x1) and rows [y0, y1); columns may pass the right edge once and
  /// wrap.
  dvec3 block(uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) const;
  const dvec3& sum(uint32_t x, uint32_t y) const { return sums_[size_t(y) * (width_ + 1) + x]; }

  uint32_t width_, height_;
  std::vector<dvec3>
      sums_;  // [(height + 1) x (width + 1)]: integral over everything above and left of a lattice point
  LightMoments moments_;
};

}  // namespace boxlight
