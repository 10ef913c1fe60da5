// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/kernels/visibility_table.h"

namespace boxlight {

/// Finds the box that explains most of a residual: it maximises (sum of residuals)^2 / (sum of weights).
class VisibilitySearch {
 public:
  /// `cells`: residual and weight. Without `takesAway` boxes of negative residual are worth nothing.
  void build(const std::vector<dvec2>& cells, bool takesAway);

  /// Starts from boxes of power-of-two sizes, descends the best of them. Returns the gain, 0 if there is
  /// none.
  double find(GridBox& best) const;
  /// Moves the four edges, one after the other, as long as that helps. Returns the gain.
  double descend(GridBox& box, int sweeps) const;

 private:
  double gain(const GridBox& box) const;
  bool move(GridBox& box, double& best) const;

  bool takesAway_ = false;
  VisibilityTable table_;
};

}  // namespace boxlight
