// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/sampler.h"
#include "bake/transport/surface.h"

namespace boxlight {

/// Paths live at least this many bounces; then Russian roulette ends them with a probability that their
/// throughput decides.
inline constexpr uint32_t kRouletteStart = 4;
inline constexpr float kMaximumSurvival = 0.95f;  ///< so that paths end in a cavity of albedo 1, too
inline constexpr uint32_t kUnlimitedBounces = ~0u;

/// After bounce number `bounce` (0 is the first): false if the path ends by the limit or by Russian roulette,
/// else the throughput is scaled by the inverse of its chance.
inline bool continuePath(uint32_t bounce, uint32_t limit, Rgb& throughput, Sampler& sampler) {
  if (bounce + 1 >= limit) return false;
  if (bounce < kRouletteStart) return true;
  const float survival = std::min(maxComponent(throughput), kMaximumSurvival);
  if (sampler.next() >= survival) return false;
  throughput /= survival;
  return true;
}

/// Samples the BSDF: turns `direction` (towards the surface) into the next one (away from it) and multiplies
/// the throughput. Returns the density per steradian of that direction, 0 if the path ends. A direction below
/// the geometric horizon would start inside the object: it ends the path.
template <class BsdfModel>
float scatter(const SurfaceView& surface, const BsdfModel& bsdf, vec3& direction, Rgb& throughput,
              Sampler& sampler) {
  const vec3 wo = surface.toLocal(-direction);
  const float choice = sampler.next();
  const vec3 wi = bsdf.sample(wo, choice, sampler.next2());
  const float density = bsdf.density(wo, wi);
  direction = surface.toWorld(wi);
  if (!(density > 0.0f) || glm::dot(direction, surface.geometricNormal) <= 0.0f) return 0.0f;
  throughput *= bsdf.evaluate(wo, wi).sum() / density;
  return maxComponent(throughput) > 0.0f ? density : 0.0f;
}

}  // namespace boxlight
