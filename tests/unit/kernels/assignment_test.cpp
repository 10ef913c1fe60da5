// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/kernel_lab.h"

namespace boxlight {
namespace {

double priceOf(const std::vector<float>& cost, const std::vector<int>& assignment) {
  double sum = 0.0;
  for (size_t row = 0; row < assignment.size(); ++row)
    sum += cost[row * assignment.size() + size_t(assignment[row])];
  return sum;
}

TEST(Assignment, IsTheCheapestOfAllPermutations) {
  lab::Random random(1);
  for (int round = 0; round < 200; ++round) {
    const int size = 1 + round % 6;
    std::vector<float> cost(size_t(size) * size_t(size));
    for (float& c : cost) c = std::floor(10.0f * random.uniform()) - 2.0f;  // many ties, some negative
    std::vector<int> permutation(size);
    std::iota(permutation.begin(), permutation.end(), 0);
    double cheapest = 1e30;
    do cheapest = std::min(cheapest, priceOf(cost, permutation));
    while (std::next_permutation(permutation.begin(), permutation.end()));

    std::vector<int> found = cheapestAssignment(cost, size);
    EXPECT_EQ(priceOf(cost, found), cheapest);
    std::sort(found.begin(), found.end());
    for (int i = 0; i < size; ++i) EXPECT_EQ(found[i], i);
  }
}

TEST(Assignment, SixtyFourAreUnshuffled) {
  const int size = 64;
  std::vector<int> shuffle(size);
  for (int i = 0; i < size; ++i) shuffle[i] = (i * 27 + 5) % size;
  std::vector<float> cost(size * size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      cost[row * size + column] = float((shuffle[row] - column) * (shuffle[row] - column));
  EXPECT_EQ(cheapestAssignment(cost, size), shuffle);
}

}  // namespace
}  // namespace boxlight
