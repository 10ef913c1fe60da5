// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/sampler.h"

#include <gtest/gtest.h>

#include <vector>

using namespace boxlight;

namespace {

/// Numbers drawn for one path, in order.
std::vector<float> draw(const StreamKey& key, uint32_t path) {
  Sampler sampler(key, path);
  std::vector<float> values;
  for (uint32_t i = 0; i < Sampler::kStratifiedPairs + 3; ++i) {
    const vec2 pair = sampler.next2();
    values.insert(values.end(), {pair.x, pair.y, sampler.next()});
  }
  return values;
}

}  // namespace

TEST(Sampler, IsAFunctionOfItsKeyAlone) {
  const StreamKey key{7, 11, 13};
  EXPECT_EQ(draw(key, 5), draw(key, 5));
  EXPECT_NE(draw(key, 5), draw(key, 6));
  EXPECT_NE(draw(key, 5), draw({8, 11, 13}, 5));
  EXPECT_NE(draw(key, 5), draw({7, 12, 13}, 5));
  EXPECT_NE(draw(key, 5), draw({7, 11, 14}, 5));
}

TEST(Sampler, EveryStratifiedPairFillsAllElementaryIntervals) {
  // 64 points of a (0,2)-sequence: one in each of the 64 cells of every 2^a x 2^(6-a) grid.
  for (uint32_t pair = 0; pair < Sampler::kStratifiedPairs; ++pair)
    for (int a = 0; a <= 6; ++a) {
      std::vector<int> cell(64, 0);
      for (uint32_t path = 0; path < 64; ++path) {
        Sampler sampler({1, 2, 3}, path);
        vec2 value;
        for (uint32_t i = 0; i <= pair; ++i) value = sampler.next2();
        const int x = int(value.x * float(1 << a)), y = int(value.y * float(1 << (6 - a)));
        ++cell[size_t(y * (1 << a) + x)];
      }
      for (int count : cell) ASSERT_EQ(count, 1) << "pair " << pair << ", split " << a;
    }
}

TEST(Sampler, PairsOfOnePathAreUncorrelated) {
  double sum = 0;
  constexpr uint32_t kPaths = 4096;
  for (uint32_t path = 0; path < kPaths; ++path) {
    Sampler sampler({3, 1, 4}, path);
    const vec2 a = sampler.next2(), b = sampler.next2();
    sum += (a.x - 0.5) * (b.x - 0.5) * 12.0;
  }
  EXPECT_LT(std::abs(sum / kPaths), 4.0 / std::sqrt(double(kPaths)));
}
