// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_PIXEL_LOBE_GLSL
#define BOXLIGHT_PIXEL_LOBE_GLSL

#include "extension_textures.glsl"
#include "lobe.glsl"

const float kLeastAlpha = 1e-4;    // ggx.h: kMinAlpha
const float kMostTurn = 0.02;      // of squared alpha; beyond, no lobe stands for so many normals (Kaplanyan et al. 2016)
const float kLeastTangent = 1e-4;  // of an anisotropy's direction in the plane of the normal

/// The unit vector perpendicular to `normal` that is nearest to `along`.
vec3 tangentAlong(vec3 along, vec3 normal) {
  along -= dot(along, normal) * normal;
  float size = length(along);
  vec3 any = abs(normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return size > kLeastTangent ? along / size : normalize(any - dot(any, normal) * normal);
}

/// lobe_boxes.h: lobeTangent.
vec3 isotropicTangent(vec3 normal, vec3 toEye) {
  vec3 mirror = reflect(-toEye, normal);
  return tangentAlong(vec3(-mirror.z, 0.0, mirror.x), normal);
}

vec3 roundTangent(NormalTurn turn, vec3 normal, vec3 toEye) {
  if (turn.variance.x > 0.0 && dot(turn.along, turn.along) > 0.0) return tangentAlong(normalize(turn.along), normal);
  return isotropicTangent(normal, toEye);
}

vec3 lobeTangent(Anisotropy anisotropy, SurfacePoint point, vec3 normal, vec3 toEye) {
  if (anisotropy.strength <= 0.0) return roundTangent(point.turn, normal, toEye);
  return tangentAlong(fromTangentSpace(vec3(anisotropy.direction, 0.0), point), normal);
}

/// `turn`: of the normal inside the pixel, which sees the mean over it. The slopes of half vectors, whose variance is alpha^2 / 2 along an
/// axis, turn with it: Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", I3D 2019.
GgxLobe makeLobe(vec3 tangent, vec3 normal, vec3 toEye, vec2 alpha, NormalTurn turn) {
  GgxLobe lobe;
  lobe.frame = mat3(tangent, cross(normal, tangent), normal);
  lobe.view = toEye * lobe.frame;
  float length2 = dot(turn.along, turn.along), cosine = length2 > 0.0 ? dot(tangent, turn.along) * inversesqrt(length2) : 1.0;
  vec2 turned = mix(turn.variance.yx, turn.variance, cosine * cosine);
  lobe.alpha = max(sqrt(alpha * alpha + min(2.0 * turned, kMostTurn)), kLeastAlpha);
  lobe.f0 = lobe.f90 = vec3(1.0);
  lobe.filmed = false;
  lobe.albedo = vec3(0.0);
  return lobe;
}

/// The GGX reflection of the pixel's own normal, view and textures; its normal is raised as the bake raises it.
GgxLobe baseLobe(BaseLayer base, float roughness, Anisotropy anisotropy, SurfacePoint point, vec3 normal, vec3 toEye) {
  normal = raiseAboveHorizon(normal, toEye, kMinimumCosine);
  float alpha = roughness * roughness, along = mix(alpha, 1.0, anisotropy.strength * anisotropy.strength);
  GgxLobe lobe = makeLobe(lobeTangent(anisotropy, point, normal, toEye), normal, toEye, vec2(along, alpha), point.turn);
  lobe.f0 = base.f0;
  lobe.f90 = vec3(base.f90);
  if (anisotropy.strength > 0.0) lobe.albedo = base.reflected;
  return lobe;
}

/// KHR_materials_clearcoat: its Fresnel factor is in its weight.
GgxLobe coatLobe(float roughness, vec3 normal, vec3 toEye, NormalTurn turn) {
  normal = raiseAboveHorizon(normal, toEye, kMinimumCosine);
  return makeLobe(roundTangent(turn, normal, toEye), normal, toEye, vec2(roughness * roughness), turn);
}

#endif
