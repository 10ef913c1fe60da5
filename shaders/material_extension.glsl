// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MATERIAL_EXTENSION_GLSL
#define BOXLIGHT_MATERIAL_EXTENSION_GLSL

#include "material.glsl"

layout(constant_id = kConstantExtended) const bool kExtended = true;
layout(constant_id = kConstantClearcoat) const bool kClearcoat = true;
layout(constant_id = kConstantSheen) const bool kSheen = true;
layout(constant_id = kConstantOtherSide) const bool kOtherSide = true;

/// asset::MaterialExtension.
struct MaterialExtension {
  float ior;
  float anisotropy, anisotropyRotation;
  float clearcoat, clearcoatRoughness, clearcoatNormalScale;
  float sheenColor[3];
  float sheenRoughness;
  float transmission;
  float diffuseTransmission;
  float diffuseTransmissionColor[3];
  float iridescence, iridescenceIor, iridescenceThickness[2];
  float emissive[3];
  float absorption[3], scattering[3], scatterAnisotropy;
  TextureRef textures[12];
};

// MaterialExtension::textures.
const uint kAnisotropyTexture = 0, kClearcoatTexture = 1, kClearcoatRoughnessTexture = 2, kClearcoatNormalTexture = 3,
           kSheenColorTexture = 4, kSheenRoughnessTexture = 5, kTransmissionTexture = 6, kDiffuseTransmissionTexture = 7,
           kDiffuseTransmissionColorTexture = 8, kIridescenceTexture = 9, kIridescenceThicknessTexture = 10,
           kEmissiveTexture = 11;

layout(std430, binding = kBindMaterialExtensions) readonly buffer MaterialExtensions { MaterialExtension materialExtensions[]; };

vec3 toVec3(float v[3]) { return vec3(v[0], v[1], v[2]); }

/// Does what arrives at the other side of this material's surfaces show through?
bool showsOtherSide(uint material) {
  return materialExtensions[material].diffuseTransmission > 0.0 && (materials[material].flags & kUnlit) == 0;
}

#endif
