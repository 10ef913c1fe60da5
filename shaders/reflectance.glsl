// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_REFLECTANCE_GLSL
#define BOXLIGHT_REFLECTANCE_GLSL

#include "film.glsl"

/// glTF 2.0, appendix B, with KHR_materials_specular, and what extends it; docs/theory.md, section 7, has the formulas and
/// directional_albedo.h the means that they take. `normal`: the shading normal of the seen side.
Reflectance reflectance(uint index, SurfacePoint point, bool front, vec3 normal, vec3 toEye) {
  Material material = materials[index];
  ExtensionTextures textures;
  if (kExtended) textures = sampleExtension(index, point);
  Surface surface = sampleSurface(material, point);
  if (kExtended && (material.flags & kUnlit) != 0) return makeReflectance(vec3(0.0), vec3(0.0), surface.baseColor);
  float nDotV = max(dot(normal, toEye), kMinimumCosine), roughness = surface.roughness;
  Anisotropy anisotropy = Anisotropy(0.0, vec2(1.0, 0.0));
  Film film;
  if (kExtended) {
    surface.dielectricF0 =
        surface.specular * min(dielectricReflectance(materialExtensions[index].ior) * surface.specularColor, vec3(1.0));
    if (kFilm) {
      film = sampleFilm(surface, materialExtensions[index], textures);
      surface = coverWithFilm(surface, film, nDotV);
    }
    anisotropy = sampleAnisotropy(materialExtensions[index], textures);
    surface.roughness = isotropicRoughness(roughness, anisotropy.strength);
  }
  BaseLayer base = baseLayer(surface, nDotV);
  Reflectance result = makeReflectance(surface.baseColor * base.scattered, base.reflected, vec3(0.0));
  if (kExtended) result = extendBase(surface, base, index, textures, point, front, toEye, nDotV);
  if (kSplit) result.lobe[0] = baseLobe(base, roughness, anisotropy, point, normal, toEye);
  if (kSplit && kExtended && kFilm && film.part > 0.0) reflectFilm(result, surface, film, base);
  return result;
}

#endif
