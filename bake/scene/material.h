// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/scene.h"

namespace boxlight {

/// A point on a triangle: barycentric weights of its second and third vertex.
struct SurfacePoint {
  uint32_t triangle = 0;
  vec2 barycentric{0.0f};
};

/// glTF's material at one point, textures and vertex colours applied, in the terms of the specification's
/// appendix B and of the Khronos extensions. What a material lacks has the value that does nothing.
struct MaterialSample {
  Rgb baseColor{1.0f};  ///< linear
  float alpha = 1;      ///< coverage, for MASK and BLEND
  float metallic = 0;
  float roughness = 1;  ///< perceptual; GGX alpha is its square
  float specular = 1;   ///< KHR_materials_specular: F90 of the dielectric
  Rgb specularColor{1.0f};
  vec3 tangentNormal{0, 0, 1};  ///< from the normal map, unit, in the tangent frame

  float ior = 1.5f;
  float anisotropy = 0;            ///< strength, [0,1]
  vec2 anisotropyDirection{1, 0};  ///< unit, in the tangent frame
  float clearcoat = 0;             ///< weight of the coat, [0,1]
  float clearcoatRoughness = 0;    ///< perceptual
  vec3 clearcoatNormal{0, 0, 1};   ///< unit, in the tangent frame
  Rgb sheenColor{0.0f};
  float sheenRoughness = 0;       ///< perceptual
  float transmission = 0;         ///< of what enters a dielectric, the part that is not scattered diffusely
  float diffuseTransmission = 0;  ///< of what is scattered diffusely, the part that leaves on the other side
  Rgb diffuseTransmissionColor{1.0f};
  float iridescence = 0, iridescenceIor = 1.3f;
  float iridescenceThickness = 400;  ///< of the thin film, nanometres
  Rgb emission{0.0f};                ///< radiance that the surface itself emits, under its coat
  bool unlit = false;                ///< emits baseColor, reflects nothing
  bool volume = false;               ///< bounds a medium: refracts; else it is a thin wall
  bool multipleScattering = false;   ///< GGX lobes get back what single scattering loses
};

/// Linear RGBA of a texture at uv, with its sampler's wrap modes and magnification filter at full resolution.
vec4 sampleTexture(const Scene& scene, uint32_t texture, vec2 uv);

MaterialSample sampleMaterial(const Scene& scene, SurfacePoint point);
/// Coverage alone: what every ray needs of a MASK or BLEND material.
float sampleAlpha(const Scene& scene, SurfacePoint point);

/// Interpolated attributes at a point.
struct SurfaceFrame {
  vec3 position;
  vec3 geometricNormal;  ///< unit, of the triangle's front
  vec3 normal;           ///< unit, interpolated, not normal-mapped
  vec4 tangent;          ///< unit and orthogonal to normal; w is the bitangent's sign
};
SurfaceFrame surfaceFrame(const Scene& scene, SurfacePoint point);
/// The position in full precision: far from the origin, floats would move it off its triangle.
dvec3 surfacePosition(const Scene& scene, SurfacePoint point);

/// A unit vector of the tangent frame (a normal map's texel) in world space.
vec3 fromTangentSpace(const SurfaceFrame& frame, vec3 v);
/// The normal-mapped shading normal of the front side.
inline vec3 shadingNormal(const SurfaceFrame& frame, const MaterialSample& material) {
  return fromTangentSpace(frame, material.tangentNormal);
}

}  // namespace boxlight
