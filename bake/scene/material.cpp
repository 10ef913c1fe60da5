// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/material.h"

#include <cmath>

#include "bake/scene/corners.h"

namespace boxlight {
namespace {

using asset::kNone;

vec2 transformUv(const Scene& scene, const asset::TextureRef& ref, vec2 uv) {
  if (ref.transform == 0) return uv;
  const auto& rows = scene.textureTransforms[ref.transform - 1].rows;
  return {rows[0][0] * uv.x + rows[0][1] * uv.y + rows[0][2],
          rows[1][0] * uv.x + rows[1][1] * uv.y + rows[1][2]};
}

vec4 sample(const Scene& scene, const Corners& corners, const asset::TextureRef& ref) {
  return sampleTexture(scene, ref.texture, transformUv(scene, ref, corners.uv(ref.texcoord)));
}

// One component of a texture, 1 where there is none.
float factor(const Scene& scene, const Corners& corners, const asset::TextureRef& ref, int component) {
  return ref.texture == kNone ? 1.0f : sample(scene, corners, ref)[component];
}

Rgb colorFactor(const Scene& scene, const Corners& corners, const asset::TextureRef& ref) {
  return ref.texture == kNone ? Rgb(1.0f) : Rgb(sample(scene, corners, ref));
}

// glTF 2.0, section 3.9.3: the texture maps [0,1] to [-1,1], scale multiplies x and y.
vec3 tangentNormal(const Scene& scene, const Corners& corners, const asset::TextureRef& ref, float scale) {
  if (ref.texture == kNone) return {0, 0, 1};
  const vec3 n = vec3(sample(scene, corners, ref)) * 2.0f - 1.0f;
  return unitOr({n.x * scale, n.y * scale, n.z}, {0, 0, 1});
}

// KHR_materials_anisotropy: RG is a direction of [-1,1]^2, turned by the rotation; B scales the strength.
void sampleAnisotropy(const Scene& scene, const Corners& corners, const asset::MaterialExtension& x,
                      MaterialSample& result) {
  vec3 texel(1, 0.5f, 1);
  if (x.anisotropyTexture.texture != kNone) texel = vec3(sample(scene, corners, x.anisotropyTexture));
  const vec2 direction = vec2(texel) * 2.0f - 1.0f;
  const float length = glm::length(direction);
  const float c = std::cos(x.anisotropyRotation), s = std::sin(x.anisotropyRotation);
  const vec2 unit = length > 1e-6f ? direction / length : vec2(1, 0);
  result.anisotropyDirection = {c * unit.x - s * unit.y, s * unit.x + c * unit.y};
  result.anisotropy = x.anisotropy * texel.z;
}

void sampleExtension(const Scene& scene, const Corners& corners, const asset::MaterialExtension& x,
                     MaterialSample& result) {
  const auto one = [&](const asset::TextureRef& ref, int component) {
    return factor(scene, corners, ref, component);
  };
  result.ior = x.ior;
  if (x.anisotropy > 0.0f) sampleAnisotropy(scene, corners, x, result);
  if (x.clearcoat > 0.0f) {
    result.clearcoat = x.clearcoat * one(x.clearcoatTexture, 0);
    result.clearcoatRoughness = x.clearcoatRoughness * one(x.clearcoatRoughnessTexture, 1);
    result.clearcoatNormal = tangentNormal(scene, corners, x.clearcoatNormalTexture, x.clearcoatNormalScale);
  }
  result.sheenColor = toVec3(x.sheenColor) * colorFactor(scene, corners, x.sheenColorTexture);
  result.sheenRoughness = x.sheenRoughness * one(x.sheenRoughnessTexture, 3);
  result.transmission = x.transmission * one(x.transmissionTexture, 0);
  result.diffuseTransmission = x.diffuseTransmission * one(x.diffuseTransmissionTexture, 3);
  result.diffuseTransmissionColor =
      toVec3(x.diffuseTransmissionColor) * colorFactor(scene, corners, x.diffuseTransmissionColorTexture);
  if (x.iridescence > 0.0f) {
    result.iridescence = x.iridescence * one(x.iridescenceTexture, 0);
    result.iridescenceIor = x.iridescenceIor;
    result.iridescenceThickness =
        glm::mix(x.iridescenceThickness[0], x.iridescenceThickness[1], one(x.iridescenceThicknessTexture, 1));
  }
  result.emission = toVec3(x.emissive) * colorFactor(scene, corners, x.emissiveTexture);
}

}  // namespace

MaterialSample sampleMaterial(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const uint32_t index = corners.triangle.material;
  const asset::Material& m = scene.materials[index];
  vec4 base = vec4(m.baseColor[0], m.baseColor[1], m.baseColor[2], m.baseColor[3]) * corners.color();
  if (m.baseColorTexture.texture != kNone) base *= sample(scene, corners, m.baseColorTexture);
  MaterialSample result{
      .baseColor = Rgb(base),
      .alpha = m.flags & (asset::kAlphaMask | asset::kAlphaBlend) ? base.w : 1.0f,
      .metallic = m.metallic,
      .roughness = m.roughness,
      .specular = m.specular * factor(scene, corners, m.specularTexture, 3),
      .specularColor = toVec3(m.specularColor) * colorFactor(scene, corners, m.specularColorTexture),
      .tangentNormal = tangentNormal(scene, corners, m.normalTexture, m.normalScale),
      .unlit = (m.flags & asset::kUnlit) != 0,
      .volume = (m.flags & asset::kVolume) != 0,
      .multipleScattering = (m.flags & asset::kMultipleScattering) != 0};
  if (m.metallicRoughnessTexture.texture != kNone) {
    const vec4 texel = sample(scene, corners, m.metallicRoughnessTexture);
    result.roughness *= texel.y;
    result.metallic *= texel.z;
  }
  if (!scene.materialExtensions.empty())
    sampleExtension(scene, corners, scene.materialExtensions[index], result);
  return result;
}

float sampleAlpha(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const asset::Material& m = scene.materials[corners.triangle.material];
  if (!(m.flags & (asset::kAlphaMask | asset::kAlphaBlend))) return 1.0f;
  float alpha = m.baseColor[3] * corners.mix(corners.a.color[3], corners.b.color[3], corners.c.color[3]);
  return alpha * factor(scene, corners, m.baseColorTexture, 3);
}

}  // namespace boxlight
