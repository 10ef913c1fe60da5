// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MATERIAL_GLSL
#define BOXLIGHT_MATERIAL_GLSL

#include "mesh.glsl"
#include "texture.glsl"

struct TextureRef {
  uint texture, texcoord;
};

/// asset::Material.
struct Material {
  vec4 baseColor;
  float metallic, roughness, normalScale, alphaCutoff;
  float specular, specularColor[3];
  uint flags;
  TextureRef baseColorTexture, metallicRoughnessTexture, normalTexture, specularTexture, specularColorTexture;
  uint reserved;
};

layout(std430, binding = kBindMaterials) readonly buffer Materials { Material materials[]; };

const uint kDoubleSided = 1, kAlphaMask = 2;  // asset::MaterialFlags

/// A point of a triangle, and the points that the neighbouring pixels see of its plane.
struct SurfacePoint {
  uvec3 vertices;
  vec3 weight, weightDx, weightDy;  // barycentric
};

vec4 sampleRef(TextureRef ref, SurfacePoint point, vec4 absent) {
  if (ref.texture == kAbsent) return absent;
  uint member = kUvAt + 2 * ref.texcoord;
  vec2 uv = interpolate2(point.vertices, point.weight, member);
  vec2 dx = interpolate2(point.vertices, point.weightDx, member) - uv;
  vec2 dy = interpolate2(point.vertices, point.weightDy, member) - uv;
  return sampleTexture(ref.texture, uv, dx, dy);
}

/// Coverage at full resolution, whatever the distance: minified coverage would fade thin things away.
float sampleAlpha(Material material, uvec3 vertices, vec3 weight) {
  SurfacePoint point = SurfacePoint(vertices, weight, weight, weight);
  float color = interpolate2(vertices, weight, kColorAt + 2).y;
  return material.baseColor.a * color * sampleRef(material.baseColorTexture, point, vec4(1.0)).a;
}

#endif
