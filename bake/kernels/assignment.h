// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace boxlight {

/// The cheapest one-to-one assignment of rows to columns: result[row] = column minimises the sum of
/// cost[row * size + column]. Costs are finite. O(size^3): shortest augmenting paths with potentials,
/// R. Jonker and A. Volgenant, "A Shortest Augmenting Path Algorithm for Dense and Sparse Linear Assignment
/// Problems", 1987.
std::vector<int> cheapestAssignment(std::span<const float> cost, int size);

}  // namespace boxlight
