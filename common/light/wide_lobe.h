// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/light/light_tree.h"
#include "common/light/lobe_boxes.h"
#include "common/light/lobe_clip.h"

// A lobe under a light, behind the visibility of the texels around it, in double precision: the oracle of
// shaders/wide_lobe.glsl.

namespace boxlight {

/// What a lobe that reflects all sends: radiance, the part (luminance) that points at other surfaces, and the
/// sum of that part times its directions.
struct SeenLobe {
  dvec3 radiance{0.0};
  double hidden = 0;
  dvec3 towards{0.0};
  /// As ClippedLobe's.
  vec3 hiddenDirection() const { return ClippedLobe{.towards = towards}.hiddenDirection(); }
};

/// The visible parts of the light's cells, of a light turned by uOffset (environmentOffset). They are kept
/// when first asked for: not for several threads at once.
class VisibleCells {
 public:
  explicit VisibleCells(const FilteredVisibility& visibility, double uOffset = 0.0);
  double part(const TreeCell& cell) const;
  double part(uvec2 latticeTexel) const;

 private:
  FilteredVisibility visibility_;
  double uOffset_;
  mutable std::vector<float> parts_;  // negative where not yet known
};

/// Boxes of constant density cut off the tails of a lobe, and under a sun or a lamp their edges show. Of a
/// lobe that is wider than the lattice of the light's moments each cell of the light (LightTree) is weighed
/// by the density f of the lobe where in the cell the light is, with its moment M_c, its mean direction
/// d_c = M_c / |M_c| and its visible part V_c:
///
///   L = sum_c V_c f(d_c) n.M_c / sum_c f(e_c) n.N_c ,     N_c = int over c of w dw,  e_c = N_c / |N_c|:
///
/// a sun counts where it stands, and a constant light returns 1 - hidden. Cells are as small as the lobe
/// varies in them (kCellsToLobe), no larger than 11.25 degrees where something near them is hidden, and each
/// bright texel counts by itself, so that a sun is hidden as the maps have it.
SeenLobe seeByCells(const GgxLobe& lobe, const VisibleCells& cells, const LightMoments& light,
                    double uOffset = 0.0);

/// A cell's height over the length on which the density varies at the cell's nearest point: with half vectors
/// of slopes s there, 2 v.h alpha sqrt(1 + (s_x / alpha_x)^2 + (s_y / alpha_y)^2), alpha the smaller one.
inline constexpr double kCellsToLobe = 1.25;

/// clipLobe of lobeBoxes.
SeenLobe seeByBoxes(const GgxLobe& lobe, const FilteredVisibility& visibility, const SummedArea& light,
                    double uOffset = 0.0);

/// The smaller alpha times n.v, half the lobe's width across the plane of the view: from the first on cells
/// take part, from the second on they are all.
inline constexpr float kWideFrom = 0.005f, kWideTo = 0.01f;

/// By the one, the other, or in between by both.
SeenLobe seeLobe(const GgxLobe& lobe, const FilteredVisibility& visibility, const VisibleCells& cells,
                 const SummedArea& light, double uOffset = 0.0);
inline SeenLobe seeLobe(const GgxLobe& lobe, const FilteredVisibility& visibility, const SummedArea& light,
                        double uOffset = 0.0) {
  return seeLobe(lobe, visibility, VisibleCells(visibility, uOffset), light, uOffset);
}

}  // namespace boxlight
