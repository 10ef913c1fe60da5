// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_SURFACE_GLSL
#define BOXLIGHT_SURFACE_GLSL

#include "albedo.glsl"
#include "material.glsl"

layout(constant_id = kConstantTextured) const bool kTextured = true;
layout(constant_id = kConstantColored) const bool kColored = true;

const float kMinimumCosine = 1e-3;  // of the shading normal to the view, as the bake bends it

vec4 sampleIfTextured(TextureRef ref, SurfacePoint point, vec4 absent) {
  return kTextured ? sampleRef(ref, point, absent) : absent;
}

/// The interpolated normal of the front side.
vec3 interpolatedNormal(SurfacePoint point) { return normalize(interpolate3(point.vertices, point.weight, kNormalAt)); }

/// A direction of the tangent frame (glTF 2.0, section 3.7.2.1) on the front side; the normal where there is no tangent.
vec3 fromTangentSpace(vec3 direction, SurfacePoint point) {
  vec3 normal = interpolatedNormal(point);
  vec4 stored = interpolate4(point.vertices, point.weight, kTangentAt);
  vec3 tangent = stored.xyz - dot(stored.xyz, normal) * normal;
  float size = length(tangent);
  if (size < 1e-6) return normal;
  tangent /= size;
  vec3 bitangent = (stored.w < 0.0 ? -1.0 : 1.0) * cross(normal, tangent);
  return normalize(direction.x * tangent + direction.y * bitangent + direction.z * normal);
}

/// The interpolated normal, bent by the value of a normal map.
vec3 bentNormal(vec3 texel, float scale, SurfacePoint point) {
  vec3 mapped = 2.0 * texel - 1.0;
  return fromTangentSpace(vec3(scale * mapped.xy, mapped.z), point);
}

vec3 shadingNormal(Material material, SurfacePoint point) {
  if (!kTextured || material.normalTexture.texture == kAbsent) return interpolatedNormal(point);
  return bentNormal(sampleRef(material.normalTexture, point, vec4(1.0)).xyz, material.normalScale, point);
}

/// The metallic-roughness core at a point, textures and vertex colours applied.
struct Surface {
  vec3 baseColor;
  float metallic, roughness, specular;
  vec3 specularColor;
  vec3 dielectricF0, conductorF0;  // reflectances at normal incidence of the two that metallic mixes
};

Surface sampleSurface(Material material, SurfacePoint point) {
  vec3 color = kColored ? interpolate3(point.vertices, point.weight, kColorAt) : vec3(1.0);
  vec4 roughMetal = sampleIfTextured(material.metallicRoughnessTexture, point, vec4(1.0));
  Surface surface;
  surface.baseColor = material.baseColor.rgb * color * sampleIfTextured(material.baseColorTexture, point, vec4(1.0)).rgb;
  surface.metallic = material.metallic * roughMetal.b;
  surface.roughness = material.roughness * roughMetal.g;
  surface.specular = material.specular * sampleIfTextured(material.specularTexture, point, vec4(1.0)).a;
  surface.specularColor = vec3(material.specularColor[0], material.specularColor[1], material.specularColor[2]) *
                          sampleIfTextured(material.specularColorTexture, point, vec4(1.0)).rgb;
  surface.dielectricF0 = surface.specular * min(0.04 * surface.specularColor, vec3(1.0));
  surface.conductorF0 = surface.baseColor;
  return surface;
}

float strongest(vec3 v) { return max(v.r, max(v.g, v.b)); }

/// The core's part of the pixel.
struct BaseLayer {
  vec3 f0;
  float f90;
  vec2 albedo;      // (A, B)
  float scattered;  // k_d (1 - metallic)
  vec3 reflected;   // F0 A + F90 B
};

BaseLayer baseLayer(Surface surface, float nDotV) {
  float dielectric = strongest(surface.dielectricF0);
  BaseLayer base;
  base.scattered = (1.0 - surface.metallic) *
                   (1.0 - mix(dielectric, surface.specular, diffuseFresnel(nDotV)));
  base.f0 = mix(surface.dielectricF0, surface.conductorF0, surface.metallic);
  base.f90 = mix(surface.specular, 1.0, surface.metallic);
  base.albedo = specularAlbedo(surface.roughness, nDotV);
  base.reflected = base.f0 * base.albedo.x + base.f90 * base.albedo.y;
  return base;
}

#endif
