// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "common/asset/asset_reader.h"
#include "common/light/summed_area.h"
#include "common/light/view_sphere.h"

// Equation 3 in double precision on the CPU: the oracle that the shaders are tested against, and the place
// where the interpolation between views is defined. The GLSL mirrors interpolateBoxes line by line.

namespace boxlight {

/// What is interpolated beside the geometry of a box: its energy, which keeps a constant environment exact,
/// or its weight w, the literal reading of the sketch, kept to be measured.
enum class Interpolation { energy, weight };

struct InterpolatedBox {
  Rectangle rectangle;
  dvec3 energy{0.0};  ///< w * Omega(rectangle)
};

/// Box j of a texel for a view between three; `weight`, the view's barycentric weights, sums to 1.
///
///   g_k = weight_k where box k has energy, else 0: an empty box has no place.   G = sum g_k; if 0, all is 0.
///   du = sum g_k du_k / G   v0 = sum g_k v0_k / G   v1 = sum g_k (v0_k + dv_k) / G
///   c_k = u0_k + du_k / 2,  h_k = g_k where du_k < 1, else 0: a full ring has no centre.
///   c = arg(sum h_k exp(2 pi i c_k)) / 2 pi, the mean on the circle (for centres close together the weighted
///     mean, to third order): the shortest way round, and the same at an edge of two view triangles from
///     either, which no linear mean is where three centres lie around the whole circle.
///   u0 = fract(c - du / 2), or 0 if all h are 0.
///   energy = sum weight_k energy_k for Interpolation::energy,
///            Omega(du, v0, v1) sum weight_k energy_k / Omega_k for Interpolation::weight.
///
/// Convexity keeps du in (0,1] and 0 <= v0 < v1 <= 1, whatever touches a pole.
InterpolatedBox interpolateBoxes(const std::array<Box, 3>& boxes, vec3 weight, Interpolation interpolation);

/// Demodulated radiance of one side of a texel: times albedo and k_d, and times the directional albedo, it is
/// what a camera sees.
struct TexelRadiance {
  dvec3 diffuse{0.0}, glossy{0.0};
  double hidden = 0;  ///< of a split lobe: the part that `glossy` stands for (lobe_clip.h)
};

/// Diffuse radiance of one side of a texel, and its gradient in the normal n, one column a channel: to first
/// order it is radiance + gradient^T (n' - (n'.n) n) for a normal n' that a normal map bends inside the
/// texel.
struct DiffuseRadiance {
  dvec3 radiance{0.0};
  dmat3 gradient{0.0};
};

/// What cosine boxes return together, not below 0:
///
///   D = sum_j a_j max(n . M_j, 0) / pi  per channel,  M_j = int over box j of L w dw ,
///
/// and of the whole sphere the irradiance of the hemisphere above n (LightMoments).
DiffuseRadiance straightRadiance(std::span<const CosineBox> boxes, dvec3 normal, const SummedArea& lights,
                                 double uOffset = 0.0);

/// Boxes closer to the horizon, and those below it that bounced light comes from, fade out of the gradient.
inline constexpr double kLeastGradientCosine = 0.1;

/// The spheres of views, by the numbers that records have (asset::Asset::viewSphere).
std::vector<ViewSphere> viewSpheresOf(const asset::Asset& asset);

/// Where decoded pages come from: AssetReader::page, or memory.
using PageProvider = std::function<std::vector<PackedBox>(uint32_t stream, uint32_t tile)>;

/// Relights texels of one asset. Pages are decoded once and kept. Not for concurrent use.
class Relighter {
 public:
  explicit Relighter(const asset::AssetReader& reader);
  Relighter(const asset::Asset& asset, PageProvider pages);  ///< both must outlive this

  /// Radiance that leaves `record` towards `eye` under the light of `lights` turned by `uOffset`. The view
  /// direction is raised to kHorizonCosine above the record's normal. The first `maxBoxes` boxes take part;
  /// they are stored by falling energy, cosine boxes first. Emitted radiance is added to them, interpolated
  /// like energy. A view without a kernel for this record is left out and the weights of the others are
  /// scaled to sum to 1. Of a record with asset::kSplitLobe the glossy radiance is what its hidden directions
  /// send: the sum over the three views of weight_k times each kernel's own radiance; a view without a kernel
  /// hides nothing. Of one with asset::kDirectionCells it is 0: there it is arriving(), for a direction that
  /// only pixels know.
  TexelRadiance relight(uint32_t record, vec3 eye, const SummedArea& lights, double uOffset = 0.0,
                        Interpolation interpolation = Interpolation::energy, uint32_t maxBoxes = ~0u);

  /// What arrives at a record with asset::kDirectionCells from around the unit vector `direction` by way of
  /// other surfaces (`glossy`), and the part of the directions there that point at some (`hidden`): the same
  /// sum over the three direction cells around it.
  TexelRadiance arriving(uint32_t record, vec3 direction, const SummedArea& lights, double uOffset = 0.0,
                         uint32_t maxBoxes = ~0u);

  /// The diffuse part of relight(), and how it changes with the normal: what cosine boxes return is the
  /// normal times a moment of the light, which is its gradient; a light box's light is taken as coming from
  /// its mean direction d, whose cosine n.d is divided out and n'.d multiplied in:
  ///   G = sum_j a_j int over box j of L w dw / pi
  ///     + sum_j energy_j L_j (n.d_j) d_j / max((n.d_j)^2, kLeastGradientCosine^2)  over boxes with n.d_j >
  ///     0.
  DiffuseRadiance diffuse(uint32_t record, const SummedArea& lights, double uOffset = 0.0,
                          uint32_t maxBoxes = ~0u);

  /// The boxes of one kernel in slot order; empty if the record has none in this stream.
  std::span<const PackedBox> kernel(uint32_t stream, uint32_t record);

 private:
  dvec3 glossy(uint32_t record, vec3 view, const SummedArea& lights, double uOffset,
               Interpolation interpolation, uint32_t maxBoxes);
  void addHidden(uint32_t record, const ViewBlend& blend, uint32_t firstStream, const SummedArea& lights,
                 double uOffset, uint32_t maxBoxes, TexelRadiance& radiance);

  const asset::Asset& asset_;
  PageProvider pages_;
  const ViewSphere& viewsOf(uint32_t record) const { return views_[asset_.viewSphere(record)]; }

  std::vector<ViewSphere> views_;
  ViewSphere cells_;
  std::unordered_map<uint64_t, std::vector<PackedBox>> decoded_;  // by stream * tileCount + tile
};

}  // namespace boxlight
