// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/surface.h"

#include "common/light/view_sphere.h"

namespace boxlight {
namespace {

/// A volume's boundary refracts where something passes it specularly; a diffusely transmitting one only
/// scatters.
Interface interfaceOf(const Scene& scene, const SurfaceView& surface, const MediumStack& media) {
  const MaterialSample& m = surface.material;
  if (!m.volume) return {};
  Interface interface { .inside = surface.back };
  if (m.transmission <= 0.0f || m.ior <= 0.0f) return interface;
  interface.ior =
      surface.back ? media.iorWithout(scene, surface.materialIndex) / m.ior : m.ior / media.ior(scene);
  return interface;
}

/// Local x and y: along the anisotropy where there is any.
void setTangents(SurfaceView& surface, const SurfaceFrame& frame) {
  orthonormalBasis(surface.normal, surface.tangent, surface.bitangent);
  if (surface.material.anisotropy <= 0.0f) return;
  const vec3 along = fromTangentSpace(frame, vec3(surface.material.anisotropyDirection, 0.0f));
  const vec3 inPlane = along - glm::dot(along, surface.normal) * surface.normal;
  const float length = glm::length(inPlane);
  if (length < 1e-4f) return;
  surface.tangent = inPlane / length;
  surface.bitangent = glm::cross(surface.normal, surface.tangent);
}

SurfaceView view(const Scene& scene, const SurfacePoint& point, const SurfaceFrame& frame, vec3 wo, bool back,
                 const MediumStack& media) {
  SurfaceView surface;
  surface.point = point;
  surface.back = back;
  surface.material = sampleMaterial(scene, point);
  surface.materialIndex = scene.triangles[point.triangle].material;
  const float side = back ? -1.0f : 1.0f;
  surface.geometricNormal = side * frame.geometricNormal;
  surface.normal = raiseAboveHorizon(side * shadingNormal(frame, surface.material), wo, kMinimumCosine);
  setTangents(surface, frame);
  surface.interface = interfaceOf(scene, surface, media);
  if (surface.material.clearcoat > 0.0f)
    surface.coatNormal = surface.toLocal(side * fromTangentSpace(frame, surface.material.clearcoatNormal));
  return surface;
}

}  // namespace

SurfaceView viewSurface(const Scene& scene, const SurfacePoint& point, vec3 wo, const MediumStack& media) {
  const SurfaceFrame frame = surfaceFrame(scene, point);
  return view(scene, point, frame, wo, glm::dot(frame.geometricNormal, wo) < 0.0f, media);
}

SurfaceView viewSurfaceSide(const Scene& scene, const SurfacePoint& point, vec3 wo, bool back,
                            const MediumStack& media) {
  return view(scene, point, surfaceFrame(scene, point), wo, back, media);
}

Ray leaveSurface(const Scene& scene, const SurfaceView& surface, vec3 wi) {
  const float side = glm::dot(wi, surface.geometricNormal) < 0.0f ? -1.0f : 1.0f;
  return {offsetOrigin(scene, surface.point, side * surface.geometricNormal), wi};
}

}  // namespace boxlight
