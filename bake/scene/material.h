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
/// appendix B.
struct MaterialSample {
  Rgb baseColor{1.0f};  ///< linear
  float alpha = 1;      ///< coverage, for MASK
  float metallic = 0;
  float roughness = 1;  ///< perceptual; GGX alpha is its square
  float specular = 1;   ///< KHR_materials_specular: F90 of the dielectric
  Rgb specularColor{1.0f};
  vec3 tangentNormal{0, 0, 1};  ///< from the normal map, unit, in the tangent frame
};

/// Linear RGBA of a texture at uv, with its sampler's wrap modes and magnification filter at full resolution.
vec4 sampleTexture(const Scene& scene, uint32_t texture, vec2 uv);

MaterialSample sampleMaterial(const Scene& scene, SurfacePoint point);
/// Coverage alone: what the MASK test of every ray needs.
float sampleAlpha(const Scene& scene, SurfacePoint point);

/// Interpolated attributes at a point.
struct SurfaceFrame {
  vec3 position;
  vec3 geometricNormal;  ///< unit, of the triangle's front
  vec3 normal;           ///< unit, interpolated, not normal-mapped
  vec4 tangent;          ///< unit and orthogonal to normal; w is the bitangent's sign
};
SurfaceFrame surfaceFrame(const Scene& scene, SurfacePoint point);

/// The normal-mapped shading normal of the front side.
vec3 shadingNormal(const SurfaceFrame& frame, const MaterialSample& material);

}  // namespace boxlight
