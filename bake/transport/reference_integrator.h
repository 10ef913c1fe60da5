// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "bake/transport/environment_sampler.h"
#include "bake/transport/intersect.h"
#include "bake/transport/scatter.h"

namespace boxlight {

/// Power heuristic: Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 9.2.
inline float powerHeuristic(float density, float other) {
  if (std::isinf(density)) return 1.0f;
  const double a = double(density) * density, b = double(other) * other;
  return a > 0 ? float(a / (a + b)) : 0.0f;
}

/// Unbiased path tracing under the environment: light sampling and BSDF sampling, combined by multiple
/// importance sampling. Emitters of the scene are found by BSDF sampling alone. BsdfModel has the members of
/// Bsdf (bsdf.h) that are used here; tests bring models of their own.
template <class BsdfModel>
class ReferenceIntegrator {
 public:
  ReferenceIntegrator(const Intersector& world, const EnvironmentSampler& environment,
                      uint32_t maximumBounces)
      : world_(world), environment_(environment), maximumBounces_(maximumBounces) {}

  /// Radiance that leaves `point` towards -direction, by one path from within `media`.
  Rgb radiance(SurfacePoint point, vec3 direction, const MediumStack& media, Sampler& sampler) const {
    Rgb result(0.0f);
    PathState path{direction, Rgb(1.0f), media};
    for (uint32_t bounce = 0;; ++bounce) {
      const SurfaceView surface = viewSurface(world_.scene(), point, -path.direction, path.media);
      const BsdfModel bsdf(surface.material, surface.toLocal(-path.direction), surface.interface,
                           surface.coatNormal);
      result += path.throughput * bsdf.emission();
      result += path.throughput * directLight(surface, bsdf, path.media, sampler.next2());
      float density = scatter(surface, bsdf, path, sampler);
      if (density == 0.0f) return result;
      Ray ray = leaveSurface(world_.scene(), surface, path.direction);
      const Travel next = travel(world_, path.media, ray, path.throughput, sampler);
      path.direction = ray.direction;
      if (!next.point) {
        const float weight =
            path.media.innermost() ? 1.0f : powerHeuristic(density, environment_.density(path.direction));
        return result + weight * path.throughput * environment_.radiance(path.direction);
      }
      if (!continuePath(bounce, maximumBounces_, path.throughput, sampler)) return result;
      point = *next.point;
    }
  }

 private:
  /// Light that comes through a medium is left to BSDF sampling.
  Rgb directLight(const SurfaceView& surface, const BsdfModel& bsdf, MediumStack media, vec2 random) const {
    const EnvironmentSampler::Sample light = environment_.sample(random);
    const vec3 wi = surface.toLocal(light.direction);
    if (!(light.density > 0.0f) ||
        (glm::dot(light.direction, surface.geometricNormal) > 0.0f) != (wi.z > 0.0f))
      return Rgb(0.0f);
    passBoundary(surface, wi, media);
    if (media.innermost()) return Rgb(0.0f);
    const LobeValue lobe = bsdf.evaluate(wi);
    if (maxComponent(lobe.value) <= 0.0f ||
        world_.occluded(leaveSurface(world_.scene(), surface, light.direction)))
      return Rgb(0.0f);
    return lobe.value * light.radiance * (powerHeuristic(light.density, lobe.density) / light.density);
  }

  const Intersector& world_;
  const EnvironmentSampler& environment_;
  uint32_t maximumBounces_;
};

}  // namespace boxlight
