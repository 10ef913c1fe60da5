// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/transport/deposits.h"
#include "common/light/box.h"

namespace boxlight {

/// Fits cosine boxes (box.h) to the light that reaches a Lambert surface straight: the part V of the texel
/// from which a direction w is seen, as a sum of boxes
///
///   V(w) ~= sum_j a_j [w in box j]   for n.w > 0 ,
///
/// by least squares in V n.w, the quantity that is integrated. Of every direction its paths tell whether it
/// is hidden, so V is 1 in the open without noise, and one box, the whole sphere, stands for all of it. Boxes
/// that reach below the horizon count there with what a reader makes of them, n.w < 0. Reusable scratch
/// memory: keep one per thread.
class VisibilityFitter {
 public:
  struct Options {
    int boxes = 16;            ///< at most, the whole sphere among them; 1 to 48
    double worthwhile = 2e-4;  ///< of what the whole hemisphere is worth, the least that a box must gain
    int refinements = 2;
  };
  explicit VisibilityFitter(Options options) : options_(options) {}

  /// `first`: cosine-distributed directions around normals whose mean is the unit vector `normal`. Boxes in
  /// the order of what they gained, amplitudes from 0 on, or with the whole sphere a sum of the others
  /// between -1 and 0 everywhere; under a constant light they return the part of the paths that went
  /// straight, but for the rounding of half floats. Empty if none did. Deterministic.
  std::vector<CosineBox> fit(std::span<const FirstDirection> first, vec3 normal);

 private:
  struct Fit;
  Options options_;
};

}  // namespace boxlight
