// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"

namespace boxlight {

/// Of the paper's observer: a display of 3840 pixels over .7 m, seen from .7 m.
inline constexpr double kFlipPixelsPerDegree = 67.02;

/// How different two pictures of one size look to someone who flips between them, pixel by pixel: 0 is equal,
/// 1 is the most that colours can differ. P. Andersson et al., "FLIP: A Difference Evaluator for Alternating
/// Images", HPG 2020, with its constants. Both are clamped to [0,1], as a display does; alpha is left aside,
/// and values that are not finite are black.
std::vector<double> flipMap(const Image& image, const Image& reference,
                            double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace boxlight
