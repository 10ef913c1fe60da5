// SPDX-License-Identifier: Apache-2.0
// Split lobes with direction cells: what takes the place of the hidden part is read where it points.
#include "tests/runtime/split_fixture.h"

namespace boxlight {
namespace {

TEST_F(SplitTest, DirectionCellsAreReadWhereTheHiddenPartPoints) {
  square_.visibility = spottedMap;
  for (const uint32_t frequency : {1u, 3u, 8u}) {
    square_.directionCells = frequency;
    for (const Finish& finish : {metal(0.05f), metal(0.3f), coated(0.3f)})
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2)
          << frequency << ' ' << finish.material.roughness;
  }
}

TEST_F(SplitTest, DirectionCellsThatSendOneLightAreAViewsKernel) {
  square_.visibility = spottedMap;
  square_.directionCells = 2;
  Finish finish = metal(0.3f);
  std::fill_n(finish.material.baseColor, 3, 0.8f);
  one_ = true;
  expectConstant(finish, 0.25f);
}

TEST_F(SplitTest, DirectionCellsSendWhatEmittersSend) {
  square_.visibility = spottedMap;
  square_.directionCells = 3;
  square_.glossyBoxes = 3;
  emitted_ = Rgb(0.5f, 2.0f, 0.1f);
  EXPECT_LT(compare(metal(0.3f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2);
}

TEST_F(SplitTest, BesideOtherRecordsDirectionCellsHaveTheirPart) {
  square_.visibility = spottedMap;
  square_.directionCells = 3;
  mixed_ = true;
  EXPECT_LT(compare(metal(0.3f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << "beside kernels of views";
  mixed_ = false, half_ = true;
  EXPECT_LT(compare(metal(0.4f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << "beside whole lobes";
}

}  // namespace
}  // namespace boxlight
