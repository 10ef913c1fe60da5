// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// The visible parts of the light's cells, turned by uOffset (environmentOffset).
class VisibleCells {
 public:
  explicit VisibleCells(const FilteredVisibility& visibility, double uOffset = 0.0);
  double part(uvec2 cell) const { return parts_[cell.y * kHorizonCells.x + cell.x]; }

 private:
  std::vector<double> parts_;
};

/// Boxes of constant density cannot follow a lobe that is wide: under a sun their edges show. Of a wide lobe
/// each cell of the light (LightMoments) is weighed by the density f of the lobe where in the cell the light
/// is, with its moment M_c, its mean direction d_c = M_c / |M_c| and its visible part V_c:
///
///   L = sum_c V_c f(d_c) n.M_c / sum_c f(e_c) n.N_c ,     N_c = int over c of w dw,  e_c = N_c / |N_c|:
///
/// a sun counts where it stands, and a constant light returns 1 - hidden. Cells are
/// of 11.25 degrees, of lobes from kMergedFrom on blocks of 2 x 2 of them where nothing is hidden, and each
/// bright texel by itself, so that a sun is hidden as the maps have it.
SeenLobe seeByCells(const GgxLobe& lobe, const FilteredVisibility& visibility, const VisibleCells& cells,
                    const LightMoments& light, double uOffset = 0.0);

/// clipLobe of lobeBoxes.
SeenLobe seeByBoxes(const GgxLobe& lobe, const FilteredVisibility& visibility, const SummedArea& light,
                    double uOffset = 0.0);

/// The smaller alpha from which on cells take part, and from which on they are all.
inline constexpr float kWideFrom = 0.1f, kWideTo = 0.13f;
inline constexpr float kMergedFrom = 0.4f;

/// By the one, the other, or in between by both.
SeenLobe seeLobe(const GgxLobe& lobe, const FilteredVisibility& visibility, const VisibleCells& cells,
                 const SummedArea& light, double uOffset = 0.0);
inline SeenLobe seeLobe(const GgxLobe& lobe, const FilteredVisibility& visibility, const SummedArea& light,
                        double uOffset = 0.0) {
  return seeLobe(lobe, visibility, VisibleCells(visibility, uOffset), light, uOffset);
}

}  // namespace boxlight
