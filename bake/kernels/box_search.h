// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "bake/kernels/deposit_grid.h"
#include "bake/kernels/grid_sat.h"

namespace boxlight {

/// Omega^-p of any box on the raster without calling pow. With polar angles a < b of its edges,
///   Omega = 4 pi * width * sin((a + b) / 2) * sin((b - a) / 2),
/// so that Omega^-p is a product of three table entries.
class SolidAnglePower {
 public:
  explicit SolidAnglePower(float exponent);
  float ofWidth(int columns) const { return width_[columns]; }
  float ofZone(int top, int bottom) const { return sine_[bottom + top] * sine_[bottom - top]; }

 private:
  std::array<float, kRasterColumns + 1> width_;
  std::array<float, 2 * kRasterRows + 1> sine_;
};

/// Finds the box that explains most of a residual: it maximises
///   gain = (|max(integral of the residual, 0)|^2 - noise) / Omega^p.
class BoxSearch {
 public:
  BoxSearch(const DepositGrid& grid, float exponent, int seeds);

  /// Starts from boxes of power-of-two sizes, descends the best of them. Returns the gain, <= 0 if no box is
  /// worth its noise.
  float find(const GridSat& residual, GridBox& best);
  /// Moves the four edges, one after the other, as long as that helps. Returns the gain.
  float descend(const GridSat& residual, GridBox& box, int sweeps);

 private:
  struct Seed {
    float gain = 0.0f;
    GridBox box;
  };
  void columnProfile(const GridSat& residual, int y0, int y1);
  void rowProfile(const GridSat& residual, int x0, int x1);
  void collectSeeds(const GridSat& residual);
  void offerSeed(float gain, const GridBox& box);
  float moveColumns(const GridSat& residual, GridBox& box);
  float moveRows(const GridSat& residual, GridBox& box);

  const DepositGrid& grid_;
  SolidAnglePower power_;
  size_t seedCount_;
  std::vector<Seed> seeds_;     // best first
  std::vector<Lanes> profile_;  // prefix sums along one axis of what lies between two lines of the other
};

}  // namespace boxlight
