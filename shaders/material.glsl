// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MATERIAL_GLSL
#define BOXLIGHT_MATERIAL_GLSL

#include "mesh.glsl"
#include "texture.glsl"

layout(constant_id = kConstantTransformed) const bool kTransformed = true;
layout(constant_id = kConstantSplit) const bool kSplit = true;

/// asset::TextureRef: `place` is the set of texture coordinates and, shifted by 16, the transform + 1.
struct TextureRef {
  uint texture, place;
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

const uint kDoubleSided = 1, kAlphaMask = 2, kAlphaBlend = 4, kUnlit = 8, kVolume = 16, kMultipleScattering = 32;  // asset::MaterialFlags

/// asset::TextureTransform.
struct TextureTransform {
  float rows[6];
};
layout(std430, binding = kBindTextureTransforms) readonly buffer TextureTransforms { TextureTransform textureTransforms[]; };

/// A point of a triangle, and the points that the neighbouring pixels see of its plane.
struct SurfacePoint {
  uvec3 vertices;
  vec3 weight, weightDx, weightDy;  // barycentric
  NormalTurn turn;  // over what the point stands for
};

/// The linear part of a reference's transform, and its offset.
struct UvTransform {
  mat2 linear;
  vec2 offset;
};

UvTransform uvTransform(TextureRef ref) {
  uint transform = ref.place >> 16;
  if (transform == 0) return UvTransform(mat2(1.0), vec2(0.0));
  float rows[6] = textureTransforms[transform - 1].rows;
  return UvTransform(mat2(rows[0], rows[3], rows[1], rows[4]), vec2(rows[2], rows[5]));
}

vec4 sampleRef(TextureRef ref, SurfacePoint point, vec4 absent) {
  if (ref.texture == kAbsent) return absent;
  uint member = kUvAt + 2 * (ref.place & 0xFFFFu);
  vec2 uv = interpolate2(point.vertices, point.weight, member);
  vec2 dx = interpolate2(point.vertices, point.weightDx, member) - uv;
  vec2 dy = interpolate2(point.vertices, point.weightDy, member) - uv;
  if (kTransformed) {
    UvTransform transform = uvTransform(ref);
    uv = transform.linear * uv + transform.offset;
    dx = transform.linear * dx;
    dy = transform.linear * dy;
  }
  return sampleTexture(ref.texture, uv, dx, dy);
}

/// Coverage at full resolution, whatever the distance: minified coverage would fade thin things away.
float sampleAlpha(Material material, uvec3 vertices, vec3 weight) {
  SurfacePoint point = SurfacePoint(vertices, weight, weight, weight, NormalTurn(vec3(0.0), vec2(0.0)));
  float color = interpolate2(vertices, weight, kColorAt + 2).y;
  return material.baseColor.a * color * sampleRef(material.baseColorTexture, point, vec4(1.0)).a;
}

#endif
