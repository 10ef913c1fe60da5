// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_PIXEL_LOBE_GLSL
#define BOXLIGHT_PIXEL_LOBE_GLSL

#include "extension_textures.glsl"
#include "lobe.glsl"

const float kLeastAlpha = 1e-4;    // ggx.h: kMinAlpha
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

const float kLeastStreak = 0.25;  // of squared alpha: below, a round lobe keeps the frame in which its boxes are best

vec3 roundTangent(NormalTurn turn, float alpha, vec3 normal, vec3 toEye) {
  return turn.variance.x > kLeastStreak * alpha * alpha ? tangentAlong(turn.along, normal) : isotropicTangent(normal, toEye);
}

vec3 lobeTangent(Anisotropy anisotropy, SurfacePoint point, float alpha, vec3 normal, vec3 toEye) {
  if (anisotropy.strength <= 0.0) return roundTangent(point.turn, alpha, normal, toEye);
  return tangentAlong(fromTangentSpace(vec3(anisotropy.direction, 0.0), point), normal);
}

const float kMostTurn = 0.02;  // added to squared alpha; beyond, no lobe stands for so many normals

/// `turn`: of the normal inside the pixel, which sees the mean over it. The slopes of half vectors turn with it, so alpha^2 grows with its
/// variance: by twice that in Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", I3D 2019; by once here, since GGX has
/// longer tails than the square of normals that a pixel sees (docs/decisions/014-small-pictures.md).
GgxLobe makeLobe(vec3 tangent, vec3 normal, vec3 toEye, vec2 alpha, NormalTurn turn) {
  GgxLobe lobe;
  lobe.frame = mat3(tangent, cross(normal, tangent), normal);
  lobe.view = toEye * lobe.frame;
  float cosine = dot(tangent, turn.along);
  vec2 turned = mix(turn.variance.yx, turn.variance, cosine * cosine);
  // Boxes would be strips on one side of a curve and rings on the other: the sharpest lobes stay round.
  float least = min(turned.x, turned.y), cells = partByCells(sqrt(min(alpha.x, alpha.y) * min(alpha.x, alpha.y) + least), lobe.view.z);
  turned = mix(vec2(least), turned, cells);
  lobe.alpha = max(sqrt(alpha * alpha + min(turned, kMostTurn)), kLeastAlpha);
  lobe.f0 = lobe.f90 = vec3(1.0);
  lobe.filmed = false;
  lobe.albedo = vec3(0.0);
  return lobe;
}

/// The GGX reflection of the pixel's own normal, view and textures; its normal is raised as the bake raises it.
GgxLobe baseLobe(BaseLayer base, float roughness, Anisotropy anisotropy, SurfacePoint point, vec3 normal, vec3 toEye) {
  normal = raiseAboveHorizon(normal, toEye, kMinimumCosine);
  float alpha = roughness * roughness, along = mix(alpha, 1.0, anisotropy.strength * anisotropy.strength);
  GgxLobe lobe = makeLobe(lobeTangent(anisotropy, point, alpha, normal, toEye), normal, toEye, vec2(along, alpha), point.turn);
  lobe.f0 = base.f0;
  lobe.f90 = vec3(base.f90);
  if (anisotropy.strength > 0.0) lobe.albedo = base.reflected;
  return lobe;
}

/// KHR_materials_clearcoat: its Fresnel factor is in its weight.
GgxLobe coatLobe(float roughness, vec3 normal, vec3 toEye, NormalTurn turn) {
  normal = raiseAboveHorizon(normal, toEye, kMinimumCosine);
  return makeLobe(roundTangent(turn, roughness * roughness, normal, toEye), normal, toEye, vec2(roughness * roughness), turn);
}

#endif
