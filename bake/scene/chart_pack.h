// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/scene/chart.h"

namespace boxlight {

/// Where charts go in a square atlas.
///
/// Each chart has a rectangle of whole texels of its own; small ones share one where their gutters would cost
/// too much (Packing::shared). Between rectangles there are at least `gutter` texels: with two, the four
/// texels of a bilinear filter are of its own chart or nearer to it than to any other. With 2 L, rectangles
/// start at multiples of L and the same holds in the level that is L times coarser, L = 2 and 4.
struct Packing {
  double texelsPerMetre = 0;  ///< of charts whose texel scale is 1
  uint32_t gutter = 0;        ///< 2, 4 or 8 texels
  uint32_t rectangles = 0;
  uint32_t shared = 0;        ///< charts that share their rectangle with others
  double crumb = 0;           ///< texels: charts up to this long, or an eighth as high, may share
  std::vector<dvec2> origin;  ///< of each chart, texels
};

/// What decides which small charts share a rectangle: those of one key, in order of `place`.
struct ChartKin {
  uint64_t key;    ///< material and main direction
  uint64_t place;  ///< along a space-filling curve
};

/// The densest packing found. The gutter is the widest of 8, 4 and 2 that costs at most 15 % of the
/// density. Charts that are smaller than a texel share rectangles with their kin; larger ones do so only
/// while the atlas would otherwise be less than half as dense as one without gutters: up to all of them in
/// one rectangle, so that any number fits.
Packing packCharts(std::span<const Chart> charts, std::span<const ChartKin> kin, uint32_t atlasSize);

}  // namespace boxlight
