// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_EXTENSION_TEXTURES_GLSL
#define BOXLIGHT_EXTENSION_TEXTURES_GLSL

#include "material_extension.glsl"
#include "surface.glsl"

/// The textures of a MaterialExtension at a point, by their places in it; white where there is none.
struct ExtensionTextures {
  vec4 value[12];
  bool coatNormal, anisotropy;  // are there these two?
};

/// One loop over those that there are: filtering is much code, which compilers would repeat for each texture.
ExtensionTextures sampleExtension(uint index, SurfacePoint point) {
  ExtensionTextures textures;
  uint pending = 0;
  for (uint i = 0; i < 12; ++i) {
    textures.value[i] = vec4(1.0);
    if (kTextured && materialExtensions[index].textures[i].texture != kAbsent) pending |= 1u << i;
  }
  textures.coatNormal = (pending >> kClearcoatNormalTexture & 1) != 0;
  textures.anisotropy = (pending >> kAnisotropyTexture & 1) != 0;
  for (; kTextured && pending != 0; pending &= pending - 1) {
    uint i = findLSB(pending);
    textures.value[i] = sampleRef(materialExtensions[index].textures[i], point, vec4(1.0));
  }
  return textures;
}

/// KHR_materials_anisotropy: strength, and the direction of the rough axis in the tangent frame.
struct Anisotropy {
  float strength;
  vec2 direction;
};

Anisotropy sampleAnisotropy(MaterialExtension extension, ExtensionTextures textures) {
  vec4 texel = textures.value[kAnisotropyTexture];
  vec2 direction = textures.anisotropy ? 2.0 * texel.rg - 1.0 : vec2(1.0, 0.0);
  float size = length(direction), c = cos(extension.anisotropyRotation), s = sin(extension.anisotropyRotation);
  direction = size > 1e-6 ? direction / size : vec2(1.0, 0.0);
  return Anisotropy(extension.anisotropy * texel.b, vec2(c * direction.x - s * direction.y, s * direction.x + c * direction.y));
}

#endif
