// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_FILM_GLSL
#define BOXLIGHT_FILM_GLSL

#include "extension_reflectance.glsl"
#include "thin_film.glsl"

/// KHR_materials_iridescence at a point: what covers the surface, in nanometres, and the F0 below it.
struct Film {
  float part, ior, thickness;
  vec3 dielectricF0, conductorF0;
};

Film sampleFilm(Surface surface, MaterialExtension extension, ExtensionTextures textures) {
  Film film = Film(extension.iridescence * textures.value[kIridescenceTexture].r, extension.iridescenceIor,
                   mix(extension.iridescenceThickness[0], extension.iridescenceThickness[1],
                       textures.value[kIridescenceThicknessTexture].g),
                   surface.dielectricF0, surface.conductorF0);
  if (film.thickness <= 0.0) film.part = 0.0;
  return film;
}

/// With the F0 that stand in for the film's reflectance at this cosine (fresnel.cpp in the bake).
Surface coverWithFilm(Surface surface, Film film, float nDotV) {
  if (film.part <= 0.0) return surface;
  vec3 dielectric = thinFilmReflectance(nDotV, film.ior, film.thickness, film.dielectricF0);
  vec3 conductor = thinFilmReflectance(nDotV, film.ior, film.thickness, film.conductorF0);
  surface.dielectricF0 = mix(film.dielectricF0, schlickF0(dielectric, nDotV), film.part);
  surface.conductorF0 = mix(film.conductorF0, schlickF0(conductor, nDotV), film.part);
  return surface;
}

/// What microfacets reflect at this cosine of view and half vector.
vec3 filmedFresnel(Surface surface, Film film, float vDotH) {
  float weight = schlickWeight(vDotH);
  vec3 dielectric = thinFilmReflectance(vDotH, film.ior, film.thickness, film.dielectricF0);
  vec3 conductor = thinFilmReflectance(vDotH, film.ior, film.thickness, film.conductorF0);
  dielectric = mix(mix(film.dielectricF0, vec3(surface.specular), weight), dielectric, film.part);
  conductor = mix(mix(film.conductorF0, vec3(1.0), weight), conductor, film.part);
  return mix(dielectric, conductor, surface.metallic);
}

const float kLeastFilmWidth = 0.01;  // film_lobe.cpp
const float kLeastReflected = 1e-6;  // that the kernels' factor is divided by

/// film_lobe.h: fitFresnel.
void fitFilm(inout GgxLobe lobe, Surface surface, Film film) {
  float sum = 0.0, squares = 0.0;
  for (uint i = 0; i < 4; ++i) {
    float side = (i & 1) == 0 ? 1.0 : -1.0;
    vec2 around = i < 2 ? vec2(side, 0.0) : vec2(0.0, side);
    float cosine = dot(lobe.view, sampleVisibleNormal(lobe.view, lobe.alpha, around, 0.5));
    sum += cosine;
    squares += cosine * cosine;
  }
  float mean = 0.25 * sum, deviation = sqrt(max(0.25 * squares - mean * mean, 0.0));
  vec3 fresnel[2];
  float weight[2];
  for (uint i = 0; i < 2; ++i) {
    float cosine = clamp(mean + (i == 0 ? -deviation : deviation), 0.0, 1.0);
    fresnel[i] = filmedFresnel(surface, film, cosine);
    weight[i] = schlickWeight(cosine);
  }
  vec3 slope = (fresnel[0] - fresnel[1]) / max(weight[0] - weight[1], kLeastFilmWidth);
  lobe.f0 = 0.5 * (fresnel[0] + fresnel[1] - (weight[0] + weight[1]) * slope);
  lobe.f90 = lobe.f0 + slope;
  lobe.filmed = true;
}

/// The pixel's own lobe takes the film as it is; `glossy` stays what kernels are divided by.
void reflectFilm(inout Reflectance result, Surface surface, Film film, BaseLayer base) {
  fitFilm(result.lobe[0], surface, film);
  GgxLobe lobe = result.lobe[0];
  float whole = base.albedo.x + base.albedo.y;
  vec3 own = clamp(lobe.f0 * base.albedo.x + lobe.f90 * base.albedo.y, kLeastFilmed * whole, whole);
  if (lobe.albedo != vec3(0.0)) result.lobe[0].albedo = own;
  vec3 assumed = result.reflected[0];
  result.reflected[0] *= own / max(base.reflected, kLeastReflected);
  result.filmed = result.reflected[0] - assumed;
}

#endif
