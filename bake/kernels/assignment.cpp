// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/assignment.h"

#include <cassert>
#include <limits>

namespace boxlight {
namespace {

constexpr int kFree = -1;
constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// Grows one shortest path at a time from a free row to a free column, over reduced costs that stay >= 0.
class Solver {
 public:
  Solver(std::span<const float> cost, int size)
      : cost_(cost),
        size_(size),
        rowPrice_(size),
        columnPrice_(size),
        rowOf_(size, kFree),
        columnOf_(size, kFree) {}

  std::vector<int> solve() {
    for (int row = 0; row < size_; ++row) augment(row);
    return columnOf_;
  }

 private:
  double reducedCost(int row, int column) const {
    return double(cost_[size_t(row) * size_ + column]) - rowPrice_[row] - columnPrice_[column];
  }

  void augment(int start) {
    distance_.assign(size_, kUnreached);
    previous_.assign(size_, start);
    settled_.clear();
    open_.resize(size_);
    for (int column = 0; column < size_; ++column) open_[column] = column;
    int row = start, column = kFree;
    double reached = 0.0;
    while (true) {
      const size_t nearest = relax(row, reached);
      column = open_[nearest];
      reached = distance_[column];
      if (rowOf_[column] == kFree) break;
      settled_.push_back(column);
      open_.erase(open_.begin() + long(nearest));
      row = rowOf_[column];
    }
    updatePrices(start, reached);
    while (true) {  // flip the path
      const int from = previous_[column], next = columnOf_[from];
      rowOf_[column] = from;
      columnOf_[from] = column;
      if (from == start) break;
      column = next;
    }
  }

  /// Shortens the ways to the open columns through `row`; returns the place in open_ of the nearest.
  size_t relax(int row, double reached) {
    size_t nearest = 0;
    for (size_t i = 0; i < open_.size(); ++i) {
      const int column = open_[i];
      const double through = reached + reducedCost(row, column);
      if (through < distance_[column]) distance_[column] = through, previous_[column] = row;
      if (distance_[column] < distance_[open_[nearest]]) nearest = i;
    }
    return nearest;
  }

  void updatePrices(int start, double reached) {
    rowPrice_[start] += reached;
    for (int column : settled_) {
      const double slack = reached - distance_[column];
      rowPrice_[rowOf_[column]] += slack;
      columnPrice_[column] -= slack;
    }
  }

  std::span<const float> cost_;
  int size_;
  std::vector<double> rowPrice_, columnPrice_, distance_;
  std::vector<int> rowOf_, columnOf_, previous_, settled_, open_;
};

}  // namespace

std::vector<int> cheapestAssignment(std::span<const float> cost, int size) {
  assert(cost.size() == size_t(size) * size_t(size));
  return Solver(cost, size).solve();
}

}  // namespace boxlight
