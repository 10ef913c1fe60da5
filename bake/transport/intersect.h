// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "bake/scene/material.h"
#include "bake/scene/scene.h"

namespace boxlight {

/// The origin is in double precision, so that far from the world's origin it still lies where it should.
struct Ray {
  dvec3 origin{0.0};
  vec3 direction{0.0f};
  float limit = std::numeric_limits<float>::infinity();  ///< nothing beyond this distance is met
};

/// Ray queries on a scene, by Embree. A surface whose alphaMode is MASK is not there where its alpha is below
/// the cutoff; one of BLEND is there with the probability alpha, decided by a hash of the ray and the
/// triangle: for many rays that is its mean transmittance, and the same ray always meets the same. Every
/// other surface stops a ray from both sides: culling is a matter of the camera, not of light
/// (docs/theory.md). The scene must outlive it. Queries are thread-safe; the same scene gives the same hits
/// whatever the number of threads.
class Intersector {
 public:
  explicit Intersector(const Scene& scene);
  ~Intersector();
  Intersector(const Intersector&) = delete;
  Intersector& operator=(const Intersector&) = delete;

  std::optional<SurfacePoint> intersect(const Ray& ray) const;
  /// `distance` is that of the point, or the ray's limit.
  std::optional<SurfacePoint> intersect(const Ray& ray, float& distance) const;
  bool occluded(const Ray& ray) const;  ///< does anything stand between the origin and infinity?
  const Scene& scene() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Hits are found in float precision around this point: the centre of the scene's bounds on every axis on
/// which the scene is farther from 0 than it is long, where the subtraction is exact (Sterbenz's lemma), and
/// 0 on the others.
vec3 hitOrigin(const Scene& scene);

/// The point moved off the surface to the side of the unit normal by 8 units in the last place of its
/// triangle's largest coordinate about hitOrigin: enough that a ray does not meet the surface it starts from,
/// and far below any shadow's scale at any scene scale.
dvec3 offsetOrigin(const Scene& scene, const SurfacePoint& point, vec3 normal);

}  // namespace boxlight
