// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace boxlight;

namespace {

/// Calls for every cell of a level, as a walk finds them.
template <class Visit>
void walk(uint32_t level, Visit&& visit) {
  for (uint32_t root = 0; root < kTreeRoots; ++root)
    for (TreeCell cell{root}; !cell.isEnd();) {
      if (cell.level > level) {
        cell.enter();
      } else {
        visit(cell);
        cell.pass();
      }
    }
}

}  // namespace

TEST(LightTree, EveryLevelTilesTheLattice) {
  std::vector<int> places(kTreeCells);
  for (uint32_t level = 0; level < kTreeLevels; ++level) {
    std::vector<int> covered(kMomentSize.x * kMomentSize.y);
    walk(level, [&](const TreeCell& cell) {
      ++places.at(cell.place());
      const auto [at, size] = cell.texels();
      for (uint32_t y = at.y; y < at.y + size.y; ++y)
        for (uint32_t x = at.x; x < at.x + size.x; ++x) ++covered.at(y * kMomentSize.x + x);
    });
    EXPECT_TRUE(std::all_of(covered.begin(), covered.end(), [](int n) { return n == 1; })) << level;
  }
  EXPECT_TRUE(std::all_of(places.begin(), places.end(), [](int n) { return n == 1; }));
}

TEST(LightTree, CellsAreAboutAsWideAsHigh) {
  for (uint32_t level = 0; level < kTreeLevels; ++level)
    walk(level, [&](const TreeCell& cell) {
      const Rectangle r = rectangleOf(cell.texels(), 0.0);
      const double low = std::min(r.v0, 1 - r.v0 - r.dv);
      const double width = 2 * r.du * std::sin(kPiDouble * std::min(low + r.dv, 0.5)) / r.dv;
      EXPECT_LT(width, 1.6) << cell.root << ' ' << level;
      if (low > 0) {
        EXPECT_GT(width, 0.1) << cell.root << ' ' << level;
      }
    });
}

TEST(LightTree, CellsHoldTheSumsOfTheirTexels) {
  const auto moment = [](uint32_t x, uint32_t y) {
    return dmat3(dvec3(x, y, 1), dvec3(x * y, x, 2), dvec3(y, y, y));
  };
  const LightTree tree(moment);
  for (uint32_t level = 0; level < kTreeLevels; ++level)
    walk(level, [&](const TreeCell& cell) {
      dmat3 sum(0.0);
      const auto [at, size] = cell.texels();
      for (uint32_t y = at.y; y < at.y + size.y; ++y)
        for (uint32_t x = at.x; x < at.x + size.x; ++x) sum += moment(x, y);
      EXPECT_EQ(tree.cell(cell).light, sum) << cell.root << ' ' << level << ' ' << cell.leaf;
      EXPECT_EQ(tree.cell(cell).one, momentsOfOne()[cell.place()]);
    });
}

TEST(LightTree, MomentsOfOneAreThoseOfALightOfOne) {
  for (uint32_t level = 0; level < kTreeLevels; ++level) {
    dvec3 sum(0.0), up(0.0);
    walk(level, [&](const TreeCell& cell) {
      const dvec3& one = momentsOfOne()[cell.place()];
      sum += one;
      if (cell.root < kTreeRoots / 2) up += one;
    });
    EXPECT_LT(glm::length(sum), 1e-9);
    EXPECT_LT(glm::length(up - dvec3(0, kPiDouble, 0)), 1e-9) << "of the upper hemisphere";
  }
}

TEST(LightTree, RectanglesTurnWithTheLight) {
  const Rectangle r = rectangleOf({{64, 32}, {16, 8}}, 0.5);
  EXPECT_DOUBLE_EQ(r.u0, 0.75);
  EXPECT_DOUBLE_EQ(r.v0, 0.25);
  EXPECT_DOUBLE_EQ(r.du, 0.0625);
  EXPECT_DOUBLE_EQ(r.dv, 0.0625);
}
