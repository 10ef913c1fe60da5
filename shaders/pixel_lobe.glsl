// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_PIXEL_LOBE_GLSL
#define BOXLIGHT_PIXEL_LOBE_GLSL

#include "extension_textures.glsl"
#include "horizon.glsl"
#include "lobe.glsl"

layout(constant_id = kConstantSplit) const bool kSplit = true;

const float kLeastAlpha = 1e-4;    // ggx.h: kMinAlpha
const float kLeastTangent = 1e-4;  // of an anisotropy's direction in the plane of the normal

/// Local x: along the anisotropy; without one, lobe_boxes.h: lobeTangent.
vec3 lobeTangent(Anisotropy anisotropy, SurfacePoint point, vec3 normal, vec3 toEye) {
  vec3 mirror = reflect(-toEye, normal);
  vec3 along = anisotropy.strength > 0.0 ? fromTangentSpace(vec3(anisotropy.direction, 0.0), point)
                                         : vec3(-mirror.z, 0.0, mirror.x);
  along -= dot(along, normal) * normal;
  float size = length(along);
  vec3 any = abs(normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return size > kLeastTangent ? along / size : normalize(any - dot(any, normal) * normal);
}

/// The GGX reflection of the pixel's own normal, view and textures; its normal is raised as the bake raises it.
GgxLobe pixelLobe(BaseLayer base, float roughness, Anisotropy anisotropy, SurfacePoint point, vec3 normal, vec3 toEye) {
  normal = raiseAboveHorizon(normal, toEye, kMinimumCosine);
  vec3 tangent = lobeTangent(anisotropy, point, normal, toEye), bitangent = cross(normal, tangent);
  float alpha = max(roughness * roughness, kLeastAlpha);
  GgxLobe lobe;
  lobe.frame = mat3(tangent, bitangent, normal);
  lobe.view = toEye * lobe.frame;
  lobe.alpha = vec2(mix(alpha, 1.0, anisotropy.strength * anisotropy.strength), alpha);
  lobe.f0 = base.f0;
  lobe.f90 = base.f90;
  lobe.albedo = anisotropy.strength > 0.0 ? base.reflected : vec3(0.0);
  return lobe;
}

#endif
