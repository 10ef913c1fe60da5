// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/light/box.h"
#include "common/light/visibility_map.h"

// A lobe behind the visibility of the texels around it, in double precision: the oracle of
// shaders/lobe_clip.glsl.

namespace boxlight {

/// The visibility maps of the texels that a point is filtered from; weights sum to 1, those of null maps are
/// 0.
struct FilteredVisibility {
  std::array<const VisibilityMap*, 4> map{};
  std::array<float, 4> weight{};
};

/// What light reaches a point straight, and what the point sees of other surfaces.
struct ClippedLobe {
  struct Piece {
    Rectangle rectangle;
    dvec3 energy{0.0};
  };
  std::vector<Piece> pieces;
  double hidden = 0;   ///< energy (luminance) that points at other surfaces
  dvec3 towards{0.0};  ///< sum of hidden energy times the mean direction of its box
  /// Unit vector: where on the whole the hidden part points; +Y if there is none.
  vec3 hiddenDirection() const;
};

/// Every box that is not wholly visible, and large, is quartered. Of each rectangle, each map tells the
/// visible part f_k of its solid angle and the edges q_k around it; then, with the weights b_k,
///   f = sum b_k f_k,   q = sum b_k f_k q_k / f,   energy = f times the rectangle's.
/// Edges are interpolated, as the boxes of kernels are between views, so that what is seen past an edge moves
/// between texels instead of fading over. The result is continuous in the boxes and in the weights.
ClippedLobe clipLobe(std::span<const Box> lobe, const FilteredVisibility& visibility);

/// Of a rectangle's solid angle.
double visiblePart(const Rectangle& rectangle, const FilteredVisibility& visibility);

/// Of a lobe's hidden part: that of unseen directions, which is what the direct part is on average.
inline constexpr double kUnseenHidden = 1.0 / 256;

/// Radiance of a split lobe whose pieces send `direct` and whose part `hidden` is clipped away, where stored
/// kernels say that a part H of the lobe is hidden and sends I:
///   direct + T hidden (I + e d) / (H + e),   d = direct / (T (1 - hidden)),   e = kUnseenHidden.
/// `own`: T, the luminance of all that the lobe reflects over what kernels take it to; 1 but under a film.
/// Without e this is the mean radiance of the hidden directions times the hidden part; with it, what boxes at
/// the horizon lose where nothing is hidden is made up for, and nothing is divided by zero.
dvec3 splitRadiance(dvec3 direct, double hidden, dvec3 storedRadiance, double storedPart, double own = 1);

}  // namespace boxlight
