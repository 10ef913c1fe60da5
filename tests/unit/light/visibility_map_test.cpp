// SPDX-License-Identifier: Apache-2.0
#include "common/light/visibility_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/light/light_domain.h"

using namespace boxlight;

namespace {

/// Visible where `predicate` says so of a cell.
template <class F>
VisibilityMap mapOf(F predicate) {
  VisibilityMap map;
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x)
      if (predicate(x, y)) map.setVisible(x, y);
  return map;
}

void expectEqual(const Rectangle& a, const Rectangle& b) {
  EXPECT_NEAR(a.u0 - b.u0, std::round(a.u0 - b.u0), 1e-12);
  EXPECT_NEAR(a.v0, b.v0, 1e-12);
  EXPECT_NEAR(a.du, b.du, 1e-12);
  EXPECT_NEAR(a.dv, b.dv, 1e-12);
}

}  // namespace

TEST(VisibilityMap, WhatIsAllVisibleStaysAsItIs) {
  const VisibilityMap map = mapOf([](uint32_t, uint32_t) { return true; });
  for (const Rectangle whole : {Rectangle{0.3, 0.2, 0.11, 0.07}, Rectangle{0.95, 0.01, 0.2, 0.5},
                                Rectangle{0, 0, 1, 1}, Rectangle{0.5001, 0.5001, 1e-5, 1e-5}}) {
    const VisiblePart seen = scanVisible(whole, map);
    expectEqual(seen.around, whole);
    EXPECT_NEAR(seen.part, 1.0, 1e-9);
  }
}

TEST(VisibilityMap, NothingVisibleIsNothing) {
  EXPECT_EQ(scanVisible({0.1, 0.1, 0.5, 0.5}, VisibilityMap{}).part, 0.0);
  const VisibilityMap one = mapOf([](uint32_t x, uint32_t y) { return x == 64 && y == 32; });
  EXPECT_EQ(scanVisible({0.1, 0.1, 0.4, 0.4}, one).part, 0.0);  // ends where the cell begins
}

TEST(VisibilityMap, ShrinksToCellsInsideTheRectangle) {
  const VisibilityMap map = mapOf([](uint32_t x, uint32_t y) { return x >= 64 && y < 16; });
  const VisiblePart seen = scanVisible({0.4, 0.2, 0.3, 0.1}, map);
  expectEqual(seen.around, {0.5, 0.2, 0.2, 0.05});
  EXPECT_NEAR(seen.part, rectangleSolidAngle(0.2, 0.2, 0.25) / rectangleSolidAngle(0.3, 0.2, 0.3), 2e-4);
}

TEST(VisibilityMap, WrapsOverTheSeam) {
  const VisibilityMap map = mapOf([](uint32_t x, uint32_t) { return x >= 120 || x < 4; });
  const VisiblePart seen = scanVisible({0.9, 0.25, 0.3, 0.25}, map);
  expectEqual(seen.around, {120.0 / 128, 0.25, 12.0 / 128, 0.25});
  EXPECT_NEAR(seen.part, 12.0 / 128 / 0.3, 1e-12);
}

TEST(VisibilityMap, HolesCountByTheirSolidAngle) {
  const VisibilityMap map = mapOf([](uint32_t x, uint32_t y) { return (x + y) % 2 == 0; });
  const VisiblePart seen = scanVisible({0, 0, 1, 1}, map);
  EXPECT_NEAR(seen.part, 0.5, 1e-9);
  EXPECT_NEAR(seen.around.du, 1.0, 1.0 / 128);
  EXPECT_NEAR(seen.around.dv, 1.0, 1e-12);
}
