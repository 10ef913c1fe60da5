// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_REFLECTANCE_GLSL
#define BOXLIGHT_REFLECTANCE_GLSL

#include "material.glsl"

layout(constant_id = 2) const bool kTextured = true;
layout(constant_id = 3) const bool kColored = true;  // has any vertex a colour?

const float kMinimumCosine = 1e-3;  // of the shading normal to the view, as the bake bends it

/// What a pixel multiplies the demodulated radiance with.
struct Reflectance {
  vec3 diffuse, glossy;
};

vec4 sampleIfTextured(TextureRef ref, SurfacePoint point, vec4 absent) {
  return kTextured ? sampleRef(ref, point, absent) : absent;
}

/// The interpolated, normal-mapped shading normal of the front side.
vec3 shadingNormal(Material material, SurfacePoint point) {
  vec3 normal = normalize(interpolate3(point.vertices, point.weight, kNormalAt));
  if (!kTextured || material.normalTexture.texture == kAbsent) return normal;
  vec4 stored = interpolate4(point.vertices, point.weight, kTangentAt);
  vec3 tangent = stored.xyz - dot(stored.xyz, normal) * normal;
  float size = length(tangent);
  if (size < 1e-6) return normal;
  tangent /= size;
  vec3 bitangent = (stored.w < 0.0 ? -1.0 : 1.0) * cross(normal, tangent);
  vec3 mapped = 2.0 * sampleRef(material.normalTexture, point, vec4(0.5, 0.5, 1.0, 1.0)).xyz - 1.0;
  mapped.xy *= material.normalScale;
  return normalize(mapped.x * tangent + mapped.y * bitangent + mapped.z * normal);
}

/// directional_albedo.h: AlbedoTable::specular.
vec2 specularAlbedo(float roughness, float nDotV) {
  float last = float(kAlbedoNodes - 1);
  vec2 at = sqrt(clamp(vec2(roughness, nDotV), 0.0, 1.0)) * last;
  uvec2 corner = uvec2(min(at, last - 1.0));
  vec2 f = at - vec2(corner);
  uint i = 2 * (corner.y * kAlbedoNodes + corner.x), below = i + 2 * kAlbedoNodes;
  vec2 top = mix(vec2(tables[i], tables[i + 1]), vec2(tables[i + 2], tables[i + 3]), f.x);
  vec2 bottom = mix(vec2(tables[below], tables[below + 1]), vec2(tables[below + 2], tables[below + 3]), f.x);
  return mix(top, bottom, f.y);
}

/// directional_albedo.h: AlbedoTable::diffuseFresnel.
float diffuseFresnel(float nDotV) {
  float at = sqrt(clamp(nDotV, 0.0, 1.0)) * float(kAlbedoNodes - 1);
  uint i = uint(min(at, float(kAlbedoNodes - 2)));
  return mix(tables[kTableFresnel + i], tables[kTableFresnel + i + 1], at - float(i));
}

/// glTF 2.0, appendix B, with KHR_materials_specular; directional_albedo.h says how its parts are averaged.
Reflectance reflectance(Material material, SurfacePoint point, bool front, vec3 toEye) {
  vec3 color = kColored ? interpolate3(point.vertices, point.weight, kColorAt) : vec3(1.0);
  vec3 baseColor = material.baseColor.rgb * color * sampleIfTextured(material.baseColorTexture, point, vec4(1.0)).rgb;
  vec4 roughMetal = sampleIfTextured(material.metallicRoughnessTexture, point, vec4(1.0));
  float roughness = material.roughness * roughMetal.g, metallic = material.metallic * roughMetal.b;
  float specular = material.specular * sampleIfTextured(material.specularTexture, point, vec4(1.0)).a;
  vec3 specularColor = vec3(material.specularColor[0], material.specularColor[1], material.specularColor[2]) *
                       sampleIfTextured(material.specularColorTexture, point, vec4(1.0)).rgb;

  float nDotV = max(dot(shadingNormal(material, point), toEye) * (front ? 1.0 : -1.0), kMinimumCosine);
  vec3 dielectric = min(0.04 * specularColor, vec3(1.0));
  float strongest = max(dielectric.r, max(dielectric.g, dielectric.b));
  float diffuseShare = 1.0 - specular * (strongest + (1.0 - strongest) * diffuseFresnel(nDotV));
  vec3 f0 = mix(dielectric * specular, baseColor, metallic);
  float f90 = mix(specular, 1.0, metallic);
  vec2 albedo = specularAlbedo(roughness, nDotV);
  return Reflectance(baseColor * (1.0 - metallic) * diffuseShare, f0 * albedo.x + f90 * albedo.y);
}

#endif
