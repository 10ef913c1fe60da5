// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

// Colours as flip.h compares them. `rgb` is linear Rec.709 in [0,1], white is D65.

namespace boxlight::flip {

/// YyCxCz, the opponent space that pictures are blurred in, and back.
dvec3 toOpponent(dvec3 rgb);
dvec3 fromOpponent(dvec3 opponent);

/// CIELab, the chroma scaled by lightness as the Hunt effect has it.
dvec3 toHuntLab(dvec3 rgb);

/// Of two colours in toHuntLab: their HyAB distance (Abasi et al. 2020) compressed to [0,1], where green and
/// blue are 1; errors up to .4 of the largest take .95 of the range.
double colourError(dvec3 a, dvec3 b);

}  // namespace boxlight::flip
