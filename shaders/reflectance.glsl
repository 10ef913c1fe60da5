// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_REFLECTANCE_GLSL
#define BOXLIGHT_REFLECTANCE_GLSL

#include "extension_reflectance.glsl"

/// glTF 2.0, appendix B, with KHR_materials_specular, and what extends it; docs/theory.md, section 7, has the formulas and
/// directional_albedo.h the means that they take. `normal`: the shading normal of the seen side.
Reflectance reflectance(uint index, SurfacePoint point, bool front, vec3 normal, vec3 toEye) {
  Material material = materials[index];
  ExtensionTextures textures;
  if (kExtended) textures = sampleExtension(index, point);
  Surface surface = sampleSurface(material, point);
  if (kExtended && (material.flags & kUnlit) != 0) return Reflectance(vec3(0.0), vec3(0.0), vec3(0.0), surface.baseColor);
  float nDotV = max(dot(normal, toEye), kMinimumCosine);
  if (kExtended) {
    surface.dielectricF0 =
        surface.specular * min(dielectricReflectance(materialExtensions[index].ior) * surface.specularColor, vec3(1.0));
    if (kFilm) coverWithFilm(surface, materialExtensions[index], textures, nDotV);
    surface.roughness = isotropicRoughness(surface.roughness, sampleAnisotropy(materialExtensions[index], textures));
  }
  BaseLayer base = baseLayer(surface, nDotV);
  if (!kExtended) return Reflectance(surface.baseColor * base.scattered, vec3(0.0), base.reflected, vec3(0.0));
  return extendBase(surface, base, index, textures, point, front, toEye, nDotV);
}

#endif
