// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "common/image/image.h"
#include "tests/extremes/exact_sums.h"

namespace boxlight::test {

struct ExtremeMap {
  std::string name;
  Image image;  ///< an environment after readEnvironment
};

/// Light maps of 512 x 256 at the ends of what environments hold.
const std::vector<ExtremeMap>& extremeMaps();

/// Boxes at the ends of what kernels hold, by kind, for a map of 512 x 256.
struct BoxKind {
  std::string name;
  std::vector<GridBox> boxes;
};
std::vector<BoxKind> boxKinds();

/// Every texel of a 512 x 256 map as a box, row by row.
std::vector<GridBox> texelBoxes();

}  // namespace boxlight::test
