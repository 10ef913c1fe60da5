// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_weights.h"

namespace boxlight {
namespace {

float overlap(const DepositGrid& grid, const GridBox& a, const GridBox& b) {
  const int y0 = std::max(a.y0, b.y0), y1 = std::min(a.y1, b.y1);
  if (y0 >= y1) return 0.0f;
  int columns = 0;  // on the raster
  for (int turn = -1; turn <= 1; ++turn) {
    const int shift = turn * kRasterColumns;
    columns += std::max(0, std::min(grid.columnLine(a.x1), grid.columnLine(b.x1) + shift) -
                               std::max(grid.columnLine(a.x0), grid.columnLine(b.x0) + shift));
  }
  return float(columns) / float(kRasterColumns) * grid.zone(y0, y1);
}

constexpr int kMaxSweeps = 60;
constexpr float kTolerance = 1e-4f;  // of a channel's energy

}  // namespace

void BoxWeights::reset() {
  weights_.clear();
  integrals_.clear();
}

void BoxWeights::place(size_t index, const DepositGrid& grid, const std::vector<GridBox>& boxes,
                       Lanes integral) {
  if (index == size()) {
    weights_.push_back(splat(0.0f));
    integrals_.emplace_back();
  }
  integral[3] = 0.0f;
  integrals_[index] = integral;
  for (size_t j = 0; j < size(); ++j) gram(index, j) = gram(j, index) = overlap(grid, boxes[index], boxes[j]);
}

void BoxWeights::solve(Lanes total) {
  gradient_ = integrals_;
  for (size_t j = 0; j < size(); ++j)
    for (size_t i = 0; i < size(); ++i) gradient_[i] -= gram(i, j) * weights_[j];
  for (int i = 0; i < kMaxSweeps; ++i) {
    const Lanes excess = sweep() - kTolerance * total;
    if (std::max(excess[0], std::max(excess[1], excess[2])) <= 0.0f) break;
  }
}

/// Moves each weight to its optimum, given the others. Returns the largest change of a box's energy.
Lanes BoxWeights::sweep() {
  Lanes largest = splat(0.0f);
  for (size_t i = 0; i < size(); ++i) {
    const float omega = gram(i, i);
    const Lanes step = maxLanes(gradient_[i] / omega, -weights_[i]);
    weights_[i] += step;
    for (size_t j = 0; j < size(); ++j) gradient_[j] -= gram(i, j) * step;
    largest = maxLanes(largest, omega * maxLanes(step, -step));
  }
  return largest;
}

}  // namespace boxlight
