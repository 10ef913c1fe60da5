// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "bake/transport/intersect.h"
#include "bake/transport/sampler.h"

namespace boxlight {

/// The closed volumes (materials with asset::kVolume) that a path is inside of, outermost first. Closed
/// meshes nest; where they overlap, the one entered last counts. A path that leaves a volume which it never
/// entered stays as it is. No medium reaches beyond the scene's bounds: that of an open mesh ends there.
class MediumStack {
 public:
  void enter(uint32_t material);
  /// False if it was never entered.
  bool leave(uint32_t material);
  std::optional<uint32_t> innermost() const;
  /// The refractive index around the path; that of air outside of everything.
  float ior(const Scene& scene) const;
  /// The same after leaving `material`, the one entered last if there are several.
  float iorWithout(const Scene& scene, uint32_t material) const;

 private:
  static constexpr size_t kDepth = 8;  ///< volumes nested deeper are taken as absent
  std::array<uint32_t, kDepth> materials_{};
  size_t count_ = 0;
};

/// The volumes that contain a point: found by counting boundaries along one ray.
MediumStack enclosingMedia(const Intersector& world, Ray ray);

/// Follows a path to the next surface, through the medium it is in. Absorption by Beer and Lambert;
/// scattering by a random walk with the Henyey-Greenstein phase function, whose free flights are drawn for a
/// channel chosen by throughput and weighted by all three (balance heuristic). Multiplies the throughput and
/// turns the ray. Nothing if the path escapes or ends; an ended path has throughput 0.
struct Travel {
  std::optional<SurfacePoint> point;
  bool scattered = false;  ///< the ray's direction is no longer the one it started with
};
Travel travel(const Intersector& world, const MediumStack& media, Ray& ray, Rgb& throughput,
              Sampler& sampler);

}  // namespace boxlight
