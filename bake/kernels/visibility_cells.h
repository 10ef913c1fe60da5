// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/kernels/visibility_table.h"

namespace boxlight {

/// First directions of a Lambert kernel on a regular grid over the light domain, for VisibilityFitter. With
/// samples i of cosine c_i = n.w_i, straight (v_i = 1) or not (0), a sum of boxes is fitted by least squares
/// in sum_i c_i (v_i - sum_j a_j [w_i in j])^2, to which the cells below the horizon add what boxes return
/// from there, c^2 N/pi a steradian.
class VisibilityCells {
 public:
  VisibilityCells(std::span<const FirstDirection> first, vec3 normal);

  double straightPart() const { return straightPart_; }  ///< of all samples
  double worth() const { return worth_; }                ///< sum of c_i

  /// Of the samples' v_i - `open`, which is the whole sphere's amplitude.
  double data(const GridBox& box, double open) const;
  double overlap(const GridBox& a, const GridBox& b) const;

  /// The sum of all boxes. Then a box's amplitude may be changed by `step`, or as much of it as leaves the
  /// sum between -1 and 0 wherever it was there; returns how much.
  void paint(const std::vector<GridBox>& boxes, const std::vector<double>& amplitudes);
  double takeAway(const GridBox& box, double step);
  bool isPaintBounded() const;  ///< between -1 and 0 everywhere

  /// Of every cell the residual and the weight that VisibilitySearch works on. Valid until the next call.
  const std::vector<dvec2>& residual(double open, const std::vector<GridBox>& boxes,
                                     const std::vector<double>& amplitudes);

  Box toBox(const GridBox& box) const;

 private:
  template <class Run>
  void forRuns(const GridBox& box, const Run& run);

  double straightPart_ = 0, worth_ = 0;
  std::vector<dvec2> cells_;     // sum of c_i v_i, sum of c_i
  std::vector<dvec2> weighted_;  // residual, and what boxes return: sum of c_i and the part below the horizon
  VisibilityTable data_, weights_;
  std::vector<float> paint_;
};

}  // namespace boxlight
