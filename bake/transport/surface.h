// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/material.h"
#include "bake/transport/fresnel.h"
#include "bake/transport/medium.h"

namespace boxlight {

/// A surface point as light sees it from direction wo: everything turned to wo's side.
struct SurfaceView {
  SurfacePoint point;
  vec3 geometricNormal{0.0f};  ///< unit, on wo's side
  vec3 normal{0.0f};           ///< unit shading normal, the local z axis; dot(normal, wo) >= kMinimumCosine
  vec3 tangent{0.0f}, bitangent{0.0f};  ///< local x and y; x is the anisotropy's direction
  vec3 coatNormal{0, 0, 1};             ///< of the clearcoat, in the local frame
  MaterialSample material;
  uint32_t materialIndex = 0;
  Interface interface;
  bool back = false;  ///< is wo on the back side of the triangle?

  vec3 toLocal(vec3 w) const { return {glm::dot(w, tangent), glm::dot(w, bitangent), glm::dot(w, normal)}; }
  vec3 toWorld(vec3 w) const { return w.x * tangent + w.y * bitangent + w.z * normal; }
};

/// A shading normal that faces away from wo (interpolation, normal maps) is bent towards it until it does
/// not; without that, such points would be black, and a path through them would lose its energy.
inline constexpr float kMinimumCosine = 1e-3f;

/// The point seen along unit direction wo (away from the surface) from within `media`. The side is the one
/// that wo lies on.
SurfaceView viewSurface(const Scene& scene, const SurfacePoint& point, vec3 wo,
                        const MediumStack& media = {});

/// The same with the side given: for bakes, whose wo may lie slightly below the geometric horizon of a
/// texel's edge.
SurfaceView viewSurfaceSide(const Scene& scene, const SurfacePoint& point, vec3 wo, bool back,
                            const MediumStack& media = {});

/// A ray from the surface along wi, started off the surface on wi's side.
Ray leaveSurface(const Scene& scene, const SurfaceView& surface, vec3 wi);

}  // namespace boxlight
