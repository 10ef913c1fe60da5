// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/sampler.h"
#include "bake/transport/specular_lobe.h"
#include "bake/transport/surface.h"

namespace boxlight {

/// Paths live at least this many bounces; then Russian roulette ends them with a probability that their
/// throughput decides.
inline constexpr uint32_t kRouletteStart = 4;
/// From this bounce n on, paths that lose nothing end, too, with probability 1.5/n: in a closed cavity of
/// albedo 1 after 192 bounces on average. A fixed probability q would make weights that grow exponentially,
/// and an infinite variance in any white cavity that fewer than q of the paths leave at a bounce.
inline constexpr uint32_t kLongPath = 64;
inline constexpr uint32_t kUnlimitedBounces = ~0u;

/// A path on its way: where it heads, what it carries and which media it is in.
struct PathState {
  vec3 direction{0.0f};
  Rgb throughput{1.0f};
  MediumStack media;
};

/// After bounce number `bounce` (0 is the first): false if the path ends by the limit or by Russian roulette,
/// else the throughput is scaled by the inverse of its chance.
inline bool continuePath(uint32_t bounce, uint32_t limit, Rgb& throughput, Sampler& sampler) {
  if (bounce + 1 >= limit) return false;
  if (bounce < kRouletteStart) return true;
  const float longest = bounce < kLongPath ? 1.0f : 1.0f - 1.5f / float(bounce);
  const float survival = std::min(maxComponent(throughput), longest);
  if (sampler.next() >= survival) return false;
  throughput /= survival;
  return true;
}

/// Lets a path that leaves the surface on the side of wi (local) into the volume that it bounds, or out of
/// it.
inline void passBoundary(const SurfaceView& surface, vec3 wi, MediumStack& media) {
  if (wi.z >= 0.0f || !surface.material.volume) return;
  if (surface.back)
    media.leave(surface.materialIndex);
  else
    media.enter(surface.materialIndex);
}

/// Turns the path to the sampled direction `drawn` (local). False if its geometric side is not the one that
/// the local frame says: it would start inside the object, or not leave it.
inline bool turnPath(const SurfaceView& surface, const LobeSample& drawn, PathState& path) {
  const bool crosses = drawn.wi.z < 0.0f;
  if (!drawn.delta) path.direction = surface.toWorld(drawn.wi);  // a delta goes straight on
  if ((glm::dot(path.direction, surface.geometricNormal) > 0.0f) == crosses) return false;
  passBoundary(surface, drawn.wi, path.media);
  return true;
}

/// Samples the BSDF: turns the path, multiplies its throughput and lets it into or out of media. Returns the
/// density per steradian of the new direction, infinity for one that only chance could not find, 0 if the
/// path ends.
template <class BsdfModel>
float scatter(const SurfaceView& surface, const BsdfModel& bsdf, PathState& path, Sampler& sampler) {
  const float choice = sampler.next();
  const LobeSample drawn = bsdf.sample(choice, sampler.next2());
  if (!turnPath(surface, drawn, path)) return 0.0f;
  LobeValue lobe{drawn.weight, std::numeric_limits<float>::infinity()};
  if (!drawn.delta) {
    lobe = bsdf.evaluate(drawn.wi);
    if (!(lobe.density > 0.0f)) return 0.0f;
    lobe.value /= lobe.density;
  }
  path.throughput *= lobe.value;
  return maxComponent(path.throughput) > 0.0f ? lobe.density : 0.0f;
}

}  // namespace boxlight
