// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/surface.h"

#include "common/light/view_sphere.h"

namespace boxlight {
namespace {

SurfaceView view(const Scene& scene, const SurfacePoint& point, const SurfaceFrame& frame, vec3 wo,
                 bool back) {
  SurfaceView surface;
  surface.point = point;
  surface.back = back;
  surface.material = sampleMaterial(scene, point);
  surface.position = frame.position;
  const float side = back ? -1.0f : 1.0f;
  surface.geometricNormal = side * frame.geometricNormal;
  surface.normal = raiseAboveHorizon(side * shadingNormal(frame, surface.material), wo, kMinimumCosine);
  orthonormalBasis(surface.normal, surface.tangent, surface.bitangent);
  return surface;
}

}  // namespace

SurfaceView viewSurface(const Scene& scene, const SurfacePoint& point, vec3 wo) {
  const SurfaceFrame frame = surfaceFrame(scene, point);
  return view(scene, point, frame, wo, glm::dot(frame.geometricNormal, wo) < 0.0f);
}

SurfaceView viewSurfaceSide(const Scene& scene, const SurfacePoint& point, vec3 wo, bool back) {
  return view(scene, point, surfaceFrame(scene, point), wo, back);
}

Ray leaveSurface(const Scene& scene, const SurfaceView& surface, vec3 wi) {
  return {offsetOrigin(scene, surface.point, surface.position, surface.geometricNormal), wi};
}

}  // namespace boxlight
