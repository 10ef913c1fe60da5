// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_THIN_FILM_GLSL
#define BOXLIGHT_THIN_FILM_GLSL

#include "light.glsl"

float schlickWeight(float cosine) {
  float grazing = clamp(1.0 - cosine, 0.0, 1.0), squared = grazing * grazing;
  return squared * squared * grazing;
}

float boundaryReflectance(float ior, float outerIor, float cosine) {
  float root = (ior - outerIor) / (ior + outerIor);
  return mix(root * root, 1.0, schlickWeight(cosine));
}

/// thin_film.cpp: the colour of one order of interference, in linear Rec. 709.
float colourLobe(float phase, vec3 fit, float shift) {
  return fit.x * sqrt(2.0 * kPi * fit.z) * cos(fit.y * phase + shift) * exp(-phase * phase * fit.z);
}

vec3 filmSensitivity(float pathDifference, vec3 shift) {
  float phase = 2.0 * kPi * pathDifference;
  float x = colourLobe(phase, vec3(5.4856e-13, 1.6810e6, 4.3278e9), shift.x) +
            colourLobe(phase, vec3(9.7470e-14, 2.2399e6, 4.5282e9), shift.x);
  float y = colourLobe(phase, vec3(4.4201e-13, 1.7953e6, 9.3046e9), shift.y);
  float z = colourLobe(phase, vec3(5.2481e-13, 2.2084e6, 6.6121e9), shift.z);
  vec3 xyz = vec3(x, y, z) / 1.0685e-7;
  return vec3(dot(vec3(3.2404542, -1.5371385, -0.4985314), xyz), dot(vec3(-0.9692660, 1.8760108, 0.0415560), xyz),
              dot(vec3(0.0556434, -0.2040259, 1.0572252), xyz));
}

/// thin_film.h: thinFilmReflectance, mirrored line by line.
vec3 thinFilmReflectance(float cosine, float filmIor, float thickness, vec3 baseF0) {
  float ior = mix(1.0, filmIor, smoothstep(0.0, 30.0, thickness));
  float inside = sqrt(max(0.0, 1.0 - (1.0 - cosine * cosine) / (ior * ior)));
  float outer = boundaryReflectance(ior, 1.0, cosine), passed = 1.0 - outer;
  vec3 root = sqrt(clamp(baseF0, 0.0, 0.9999)), baseIor = (1.0 + root) / (1.0 - root);
  vec3 base = vec3(boundaryReflectance(baseIor.r, ior, inside), boundaryReflectance(baseIor.g, ior, inside),
                   boundaryReflectance(baseIor.b, ior, inside));
  vec3 shift = kPi + kPi * vec3(lessThan(baseIor, vec3(ior)));
  float pathDifference = 2e-9 * ior * thickness * inside;
  vec3 sum = outer + passed * passed * base / (1.0 - min(outer * base, 0.9999));
  vec3 order = sum - outer - passed;
  for (int m = 1; m <= 2; ++m) {
    order *= sqrt(outer * base);
    sum += order * 2.0 * filmSensitivity(float(m) * pathDifference, float(m) * shift);
  }
  return clamp(sum, 0.0, 1.0);
}

/// thin_film.h: schlickF0.
vec3 schlickF0(vec3 reflectance, float cosine) {
  float weight = min(schlickWeight(cosine), 0.9999);
  return clamp((reflectance - weight) / (1.0 - weight), 0.0, 1.0);
}

#endif
