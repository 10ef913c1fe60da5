// SPDX-License-Identifier: Apache-2.0
#include "common/light/bright_texels.h"

#include <gtest/gtest.h>

#include <numeric>

namespace boxlight {
namespace {

using Indices = std::vector<uint32_t>;

TEST(BrightTexels, OfAnEvenLightThereAreNone) {
  EXPECT_EQ(findBrightTexels({}), Indices{});
  EXPECT_EQ(findBrightTexels(std::vector<double>(32768, 1.0 / 32768)), Indices{});
  EXPECT_EQ(findBrightTexels(std::vector<double>(kBrightTexels + 1, 0.02)), Indices{}) << "one too many";
}

TEST(BrightTexels, AreTheBrightestInTheirOrder) {
  std::vector<double> strengths(1000, 1e-5);
  strengths[7] = 0.5, strengths[3] = 0.01, strengths[999] = 0.25;
  EXPECT_EQ(findBrightTexels(strengths), (Indices{3, 7, 999}));
}

TEST(BrightTexels, TooFaintOnesDoNotCount) {
  EXPECT_EQ(findBrightTexels(std::vector<double>{kLeastBright, 0.99 * kLeastBright, 0, -1e-9}), Indices{0});
}

TEST(BrightTexels, EqualOnesAreTakenTogether) {
  std::vector<double> strengths(100, 0.001);
  std::fill_n(strengths.begin(), kBrightTexels, 0.002);
  Indices expected(kBrightTexels);
  std::iota(expected.begin(), expected.end(), 0u);
  EXPECT_EQ(findBrightTexels(strengths), expected);
}

TEST(BrightTexels, TheWholeLightInOne) {
  EXPECT_EQ(findBrightTexels(std::vector<double>{0, 1.7}), Indices{1});
}

}  // namespace
}  // namespace boxlight
