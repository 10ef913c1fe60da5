// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_EXTENSION_REFLECTANCE_GLSL
#define BOXLIGHT_EXTENSION_REFLECTANCE_GLSL

#include "pixel_lobe.glsl"

const uint kPixelLobes = 2;  // the base's and the coat's
const float kLeastGloss = 1e-4;  // that kernels are divided by; paths.cpp

/// What a pixel multiplies the demodulated radiance with, of the seen side and of the other one, and what it adds.
struct Reflectance {
  vec3 diffuse, transmitted, glossy, emission;
  GgxLobe lobe[kPixelLobes];      // with kSplit
  vec3 reflected[kPixelLobes];  // their parts of `glossy`
  vec3 filmed;                    // of a film, what the pixel's own lobe has more than its part
};

Reflectance makeReflectance(vec3 diffuse, vec3 glossy, vec3 emission) {
  Reflectance result;
  result.diffuse = diffuse;
  result.transmitted = vec3(0.0);
  result.glossy = glossy;
  result.emission = emission;
  result.reflected = vec3[kPixelLobes](glossy, vec3(0.0));
  result.filmed = vec3(0.0);
  return result;
}

/// KHR_materials_ior; 0 stands for an infinite index.
float dielectricReflectance(float ior) {
  float root = ior == 0.0 ? 1.0 : (ior - 1.0) / (ior + 1.0);
  return root * root;
}

/// The roughness whose alpha is the geometric mean of those along the tangent and the bitangent.
float isotropicRoughness(float roughness, float anisotropy) {
  float alpha = roughness * roughness;
  return anisotropy > 0.0 ? sqrt(sqrt(mix(alpha, 1.0, anisotropy * anisotropy) * alpha)) : roughness;
}

/// Energy that single scattering between microfacets loses: Turquin, "Practical Multiple Scattering Compensation for Microfacet
/// Models", 2019.
vec3 multipleScattering(BaseLayer base) {
  float total = max(base.albedo.x + base.albedo.y, 1e-3);
  return 1.0 + base.f0 * (1.0 / total - 1.0);
}

/// KHR_materials_transmission: what the GGX lobe sends through.
vec3 transmittedLobe(Surface surface, BaseLayer base, float transmission) {
  float through = base.albedo.x * (1.0 - strongest(surface.dielectricF0)) +
                  base.albedo.y * (1.0 - surface.specular);
  return transmission * (1.0 - surface.metallic) * surface.baseColor * through;
}

/// KHR_materials_sheen: its albedo, and how much it lets through to the base.
struct SheenLayer {
  vec3 reflected;
  float passed;
};

SheenLayer sheenLayer(MaterialExtension extension, ExtensionTextures textures, float nDotV) {
  if (!kSheen) return SheenLayer(vec3(0.0), 1.0);
  vec3 color = toVec3(extension.sheenColor) * textures.value[kSheenColorTexture].rgb;
  float roughness = extension.sheenRoughness * textures.value[kSheenRoughnessTexture].a;
  float albedo = strongest(color) > 0.0 ? sheenAlbedo(roughness, nDotV) : 0.0;
  return SheenLayer(color * albedo, 1.0 - strongest(color) * albedo);
}

/// KHR_materials_clearcoat: its weight w_c, which is taken from all below it, and its albedo.
struct CoatLayer {
  float weight, albedo;
  GgxLobe lobe;  // with kSplit
};

CoatLayer coatLayer(MaterialExtension extension, ExtensionTextures textures, SurfacePoint point, bool front, vec3 toEye) {
  CoatLayer coat;
  coat.weight = coat.albedo = 0.0;
  if (!kClearcoat) return coat;
  float clearcoat = extension.clearcoat * textures.value[kClearcoatTexture].r;
  float roughness = extension.clearcoatRoughness * textures.value[kClearcoatRoughnessTexture].g;
  vec3 normal = textures.coatNormal
                    ? bentNormal(textures.value[kClearcoatNormalTexture].xyz, extension.clearcoatNormalScale, point)
                    : interpolatedNormal(point);
  normal *= front ? 1.0 : -1.0;
  float nDotV = max(dot(normal, toEye), kMinimumCosine);
  float grazing = 1.0 - nDotV, squared = grazing * grazing;
  vec2 albedo = specularAlbedo(roughness, nDotV);
  coat.weight = clearcoat * (0.04 + 0.96 * squared * squared * grazing);
  coat.albedo = albedo.x + albedo.y;
  if (kSplit) coat.lobe = coatLobe(roughness, normal, toEye, point.turn);
  return coat;
}

vec3 emittedRadiance(MaterialExtension extension, ExtensionTextures textures) {
  return toVec3(extension.emissive) * textures.value[kEmissiveTexture].rgb;
}

/// Of the light that is scattered diffusely, what leaves where it came from and what leaves on the other side.
void splitDiffuse(MaterialExtension extension, ExtensionTextures textures, vec3 baseColor, float scattered,
                  inout Reflectance result) {
  result.diffuse = scattered * baseColor;
  result.transmitted = vec3(0.0);
  if (!kOtherSide) return;
  float through = extension.diffuseTransmission * textures.value[kDiffuseTransmissionTexture].a;
  vec3 color = toVec3(extension.diffuseTransmissionColor) *
               textures.value[kDiffuseTransmissionColorTexture].rgb;
  result.diffuse *= 1.0 - through;
  result.transmitted = scattered * through * color;
}

Reflectance extendBase(Surface surface, BaseLayer base, uint index, ExtensionTextures textures, SurfacePoint point, bool front,
                       vec3 toEye, float nDotV) {
  MaterialExtension extension = materialExtensions[index];
  float transmission = extension.transmission * textures.value[kTransmissionTexture].r;
  SheenLayer sheen = sheenLayer(extension, textures, nDotV);
  CoatLayer coat = coatLayer(extension, textures, point, front, toEye);
  float below = 1.0 - coat.weight;
  if ((materials[index].flags & kMultipleScattering) != 0) base.reflected *= multipleScattering(base);
  Reflectance result = makeReflectance(vec3(0.0), vec3(0.0), vec3(0.0));
  splitDiffuse(extension, textures, surface.baseColor, below * sheen.passed * base.scattered * (1.0 - transmission), result);
  result.reflected[0] = below * sheen.passed * base.reflected;
  result.reflected[1] = vec3(coat.weight * coat.albedo);
  result.glossy = below * (sheen.passed * transmittedLobe(surface, base, transmission) + sheen.reflected) +
                  result.reflected[0] + result.reflected[1];
  if (kSplit) result.lobe[1] = coat.lobe;
  result.emission = below * emittedRadiance(extension, textures);
  return result;
}

#endif
