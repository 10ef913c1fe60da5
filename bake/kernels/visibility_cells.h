// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/kernels/deposit_grid.h"

namespace boxlight {

/// First directions of a Lambert kernel on a regular grid over the light domain, for VisibilityFitter. With
/// samples i of cosine c_i = n.w_i, straight (v_i = 1) or not (0), a sum of boxes is fitted by least squares
/// in sum_i c_i (v_i - sum_j a_j [w_i in j])^2, to which the cells below the horizon add what boxes return
/// from there, c^2 N/pi a steradian.
class VisibilityCells {
 public:
  static constexpr int kColumns = 128, kRows = 64;
  /// Of the samples: where more go straight, boxes take away from the whole sphere.
  static constexpr double kOpenPart = 0.97;

  VisibilityCells(std::span<const FirstDirection> first, vec3 normal);

  double straightPart() const { return straightPart_; }  ///< of all samples
  double worth() const { return worth_; }                ///< sum of c_i

  /// Of the samples' v_i - `open`, which is the whole sphere's amplitude.
  double data(const GridBox& box, double open) const;
  double overlap(const GridBox& a, const GridBox& b) const;

  /// The residual that find and descend work on.
  void setResidual(double open, const std::vector<GridBox>& boxes, const std::vector<double>& amplitudes);
  /// The box that explains most of the residual, and how much.
  double find(GridBox& best) const;
  double descend(GridBox& box, int sweeps) const;

  Box toBox(const GridBox& box) const;

 private:
  /// A summed-area table of two numbers a cell.
  struct Table {
    std::vector<dvec2> sums = std::vector<dvec2>(size_t(kColumns + 1) * (kRows + 1), dvec2(0));
    dvec2 leftOf(int x, int y0, int y1) const {
      return sums[size_t(y1) * (kColumns + 1) + x] - sums[size_t(y0) * (kColumns + 1) + x];
    }
    dvec2 sum(const GridBox& box) const;
    void build(const std::vector<dvec2>& cells);
  };
  double gain(const GridBox& box) const;
  bool move(GridBox& box, double& best) const;

  double straightPart_ = 0, worth_ = 0;
  std::vector<dvec2> cells_;     // sum of c_i v_i, sum of c_i
  std::vector<double> weights_;  // what boxes return: sum of c_i, and the part below the horizon
  Table data_, residual_;        // residual and weight
  std::vector<double> paint_;
};

}  // namespace boxlight
