// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>

#include "common/base/math.h"

namespace boxlight {

/// Directions, each rounded to the centre of one of 32x32 cells of the octahedral map: what a chart has to
/// remember of its normals, however many triangles it has.
class NormalSet {
 public:
  void add(dvec3 direction);
  void add(const NormalSet& other);

  struct Cone {
    dvec3 axis;     ///< unit
    double cosine;  ///< of the widest angle to a direction of the set
  };
  /// A narrow cone around all directions: the smallest enclosing one as it is approached from the mean.
  /// Badoiu and Clarkson, "Smaller Core-Sets for Balls", SODA 2003. Stops at the first that is `wanted` or
  /// narrower.
  Cone cone(dvec3 mean, double wanted = 1.0) const;

 private:
  static constexpr int kSide = 32;
  std::bitset<size_t(kSide) * kSide> cells_;
};

}  // namespace boxlight
