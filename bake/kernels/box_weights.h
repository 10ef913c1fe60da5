// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/kernels/deposit_grid.h"

namespace boxlight {

/// Weights of overlapping boxes by non-negative least squares, three channels at once. Minimises over w >= 0
/// the integral of R^2, R = T - sum_j w_j K_j. The normal equations need only the boxes' overlaps (the Gram
/// matrix; its diagonal holds their solid angles) and the integrals of T over them. A term that holds the
/// total energy makes no measurable difference: it is restored exactly in the end (box_fit.cpp).
class BoxWeights {
 public:
  void reset();
  /// Box `index` is new (index == size()) or has moved. `integral` is that of T over the box.
  void place(size_t index, const DepositGrid& grid, const std::vector<GridBox>& boxes, Lanes integral);
  /// Projected Gauss-Seidel from the current weights.
  /// `total` is the integral of T, last lane 0.
  void solve(Lanes total);

  size_t size() const { return weights_.size(); }
  Lanes weight(size_t index) const { return weights_[index]; }  ///< per steradian; last lane 0

 private:
  Lanes sweep();
  float& gram(size_t i, size_t j) { return gram_[i * kMaxBoxes + j]; }

  static constexpr size_t kMaxBoxes = 64;
  std::vector<float> gram_ = std::vector<float>(kMaxBoxes * kMaxBoxes);
  std::vector<Lanes> weights_, integrals_;
  std::vector<Lanes> gradient_;  // integral of R over each box
};

}  // namespace boxlight
