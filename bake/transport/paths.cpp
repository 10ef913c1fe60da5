// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/paths.h"

#include <cmath>

#include "bake/transport/bsdf.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kMaskTries = 16;  ///< points drawn on a texel before it counts as cut away by its mask

vec3 cosineDirection(vec2 random) {
  const float radius = std::sqrt(random.x), phi = 2.0f * kPi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0f, 1.0f - random.x))};
}

}  // namespace

bool PathTracer::startPoint(const PathOrigin& origin, Sampler& sampler, SurfacePoint& point) const {
  const Scene& scene = world_.scene();
  point = sampleFootprint(origin.footprint, sampler.next2());
  const asset::Material& material = scene.materials[scene.triangles[point.triangle].material];
  if (!(material.flags & asset::kAlphaMask)) return true;
  for (int tries = 0; tries < kMaskTries; ++tries) {
    if (sampleAlpha(scene, point) >= material.alphaCutoff) return true;
    const float u = sampler.next();
    point = sampleFootprint(origin.footprint, {u, sampler.next()});
  }
  return false;
}

void PathTracer::leave(const SurfaceView& first, vec3 direction, Rgb throughput, Sampler& sampler,
                       std::vector<Deposit>& deposits) const {
  const Scene& scene = world_.scene();
  SurfaceView surface = first;
  for (uint32_t bounce = 0;; ++bounce) {
    const auto next = world_.intersect(leaveSurface(scene, surface, direction));
    if (!next) {
      deposits.push_back({directionToUv(direction), throughput});
      return;
    }
    if (!continuePath(bounce, maximumBounces_, throughput, sampler)) return;
    surface = viewSurface(scene, *next, -direction);
    if (scatter(surface, Bsdf(surface.material), direction, throughput, sampler) == 0.0f) return;
  }
}

uint32_t PathTracer::traceLambert(const PathOrigin& origin, const StreamKey& key, uint32_t pathCount,
                                  std::vector<Deposit>& deposits) const {
  uint32_t traced = 0;
  for (uint32_t path = 0; path < pathCount; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    ++traced;
    const SurfaceView surface = viewSurfaceSide(world_.scene(), point, origin.normal, origin.back);
    const vec3 direction = surface.toWorld(cosineDirection(sampler.next2()));
    if (glm::dot(direction, surface.geometricNormal) > 0.0f)
      leave(surface, direction, Rgb(1.0f), sampler, deposits);
  }
  return traced;
}

uint32_t PathTracer::traceGlossy(const PathOrigin& origin, vec3 wo, const StreamKey& key, uint32_t pathCount,
                                 std::vector<Deposit>& deposits) const {
  uint32_t traced = 0;
  for (uint32_t path = 0; path < pathCount; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    const SurfaceView surface = viewSurfaceSide(world_.scene(), point, wo, origin.back);
    const Bsdf bsdf(surface.material);
    if (!bsdf.hasGlossy())
      continue;  // another material's part of the texel: its pixels do not ask for this kernel
    ++traced;
    const vec3 local = surface.toLocal(wo);
    Rgb weight;
    const vec3 direction = surface.toWorld(bsdf.sampleGlossy(local, sampler.next2(), weight));
    if (maxComponent(weight) <= 0.0f || glm::dot(direction, surface.geometricNormal) <= 0.0f) continue;
    leave(surface, direction, weight / glm::max(bsdf.glossyAlbedo(local.z), Rgb(1e-6f)), sampler, deposits);
  }
  return traced;
}

}  // namespace boxlight
