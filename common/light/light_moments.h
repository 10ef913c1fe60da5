// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"
#include "common/light/light_tree.h"

namespace boxlight {

/// Integrals of a distant light times its direction, int L w dw, one column a channel: what the normal n of a
/// Lambert surface is multiplied with to get its irradiance, exactly wherever in a box the light is (theory
/// 5). In double precision; shaders/moments.glsl has the same on a table of integers.
class LightMoments {
 public:
  /// `lightMap`: RGB, finite.
  explicit LightMoments(const Image& lightMap);

  /// Over the rectangle moved by uOffset (environmentOffset), in the directions of the world. Its edges in v
  /// are rounded to the lattice of kMomentSize. Inside a texel of that the light counts as even in u.
  dmat3 integrate(const Rectangle& rectangle, double uOffset = 0.0) const;

  /// In the light map's directions, without the bright texels.
  const LightTree& tree() const { return tree_; }

  /// What hemispheres and cells leave out (findBrightTexels).
  struct BrightTexel {
    uvec2 at;  ///< of the lattice of kMomentSize
    dmat3 light;
  };
  const std::vector<BrightTexel>& brightTexels() const { return bright_; }

  /// n.w integrated over the hemisphere above the unit vector `normal`: `irradiance`, exact for a constant
  /// light and for what is small and bright (findBrightTexels), smoothed over some degrees elsewhere.
  /// `moment` . normal is the same nearly, and `moment` is good for its tangential part.
  struct Hemisphere {
    dvec3 irradiance;
    dmat3 moment;
  };
  Hemisphere hemisphere(dvec3 normal, double uOffset = 0.0) const;

 private:
  void addTexels(const Image& lightMap);
  void separateBrightTexels(const Image& lightMap);
  bool isBright(uvec2 at) const;
  std::vector<LightCell> horizonCells() const;
  void makeNodes();
  dmat3 strip(uint32_t x, uint32_t y0, uint32_t y1) const;
  const dmat3& sum(uint32_t x, uint32_t y) const { return sums_[size_t(y) * (kMomentSize.x + 1) + x]; }

  std::vector<dmat3> sums_;  // over everything above and left of a lattice point
  std::vector<BrightTexel> bright_;
  LightTree tree_;
  std::vector<dmat3> nodes_;  // moments of hemispheres, without those
};

}  // namespace boxlight
