// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/environment_sampler.h"
#include "bake/transport/intersect.h"
#include "bake/transport/scatter.h"

namespace boxlight {

/// Power heuristic: Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 9.2.
inline float powerHeuristic(float density, float other) {
  const double a = double(density) * density, b = double(other) * other;
  return a > 0 ? float(a / (a + b)) : 0.0f;
}

/// Unbiased path tracing with the environment as its only light: light sampling and BSDF sampling, combined
/// by multiple importance sampling. BsdfModel has the members of Bsdf (bsdf.h); tests bring models of their
/// own.
template <class BsdfModel>
class ReferenceIntegrator {
 public:
  ReferenceIntegrator(const Intersector& world, const EnvironmentSampler& environment,
                      uint32_t maximumBounces)
      : world_(world), environment_(environment), maximumBounces_(maximumBounces) {}

  /// Radiance that leaves `point` towards -direction, by one path.
  Rgb radiance(SurfacePoint point, vec3 direction, Sampler& sampler) const {
    Rgb result(0.0f), throughput(1.0f);
    for (uint32_t bounce = 0;; ++bounce) {
      const SurfaceView surface = viewSurface(world_.scene(), point, -direction);
      const BsdfModel bsdf(surface.material);
      result += throughput * directLight(surface, bsdf, surface.toLocal(-direction), sampler.next2());
      const float density = scatter(surface, bsdf, direction, throughput, sampler);
      if (density == 0.0f) return result;
      const auto next = world_.intersect(leaveSurface(world_.scene(), surface, direction));
      if (!next) {
        const float weight = powerHeuristic(density, environment_.density(direction));
        return result + weight * throughput * environment_.radiance(direction);
      }
      if (!continuePath(bounce, maximumBounces_, throughput, sampler)) return result;
      point = *next;
    }
  }

 private:
  Rgb directLight(const SurfaceView& surface, const BsdfModel& bsdf, vec3 wo, vec2 random) const {
    const EnvironmentSampler::Sample light = environment_.sample(random);
    if (!(light.density > 0.0f) || glm::dot(light.direction, surface.geometricNormal) <= 0.0f)
      return Rgb(0.0f);
    const vec3 wi = surface.toLocal(light.direction);
    const Rgb value = bsdf.evaluate(wo, wi).sum();
    if (maxComponent(value) <= 0.0f ||
        world_.occluded(leaveSurface(world_.scene(), surface, light.direction)))
      return Rgb(0.0f);
    return value * light.radiance * (powerHeuristic(light.density, bsdf.density(wo, wi)) / light.density);
  }

  const Intersector& world_;
  const EnvironmentSampler& environment_;
  uint32_t maximumBounces_;
};

}  // namespace boxlight
