// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LOBE_GLSL
#define BOXLIGHT_LOBE_GLSL

#include "light.glsl"

layout(constant_id = kConstantFilm) const bool kFilm = true;

/// lobe_boxes.h: GgxLobe; columns of `frame` are tangent, bitangent and normal, `view` is seen in it.
struct GgxLobe {
  mat3 frame;
  vec3 view;
  vec2 alpha;
  vec3 f0, f90;
  bool filmed;
  vec3 albedo;  // that the pixel's factor has for it; 0 if that is exact
};

const float kWideFrom = 0.005, kWideTo = 0.01;  // wide_lobe.h

/// How much of a lobe is summed by cells of the light (wide_lobe.glsl); the rest is boxes.
float partByCells(float alpha, float nDotV) { return clamp((alpha * nDotV - kWideFrom) / (kWideTo - kWideFrom), 0.0, 1.0); }

/// A rectangle of the light domain.
struct Rectangle {
  float u, du;
  Latitudes latitudes;
};

/// ggx.cpp: stretchedLength.
float stretchedLength(vec3 w, vec2 alpha) { return length(vec3(alpha * w.xy, w.z)); }

/// ggx.h: sampleVisibleNormal. `around`: the point of the unit circle that the first random number turns to; `left`: 1 less the
/// second.
vec3 sampleVisibleNormal(vec3 view, vec2 alpha, vec2 around, float left) {
  vec3 stretched = normalize(vec3(alpha * view.xy, view.z));
  float height = left * (1.0 + stretched.z), z = height - stretched.z;
  float ring = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
  vec2 tangential = ring * around + stretched.xy;
  return normalize(vec3(alpha * tangential, height));
}

const float kLeastFilmed = 1e-3;  // lobe_boxes.h

/// F G2 / G1 of the reflection by a half vector drawn among those that the view sees.
vec3 reflectionWeight(GgxLobe lobe, vec3 light, vec3 halfVector) {
  float view = stretchedLength(lobe.view, lobe.alpha);
  float shadowing = light.z * (lobe.view.z + view) /
                    (light.z * view + lobe.view.z * stretchedLength(light, lobe.alpha));
  float grazing = clamp(1.0 - dot(lobe.view, halfVector), 0.0, 1.0), squared = grazing * grazing;
  vec3 fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * (squared * squared * grazing);
  if (kFilm && lobe.filmed) fresnel = clamp(fresnel, kLeastFilmed, 1.0);
  return light.z > 0.0 ? shadowing * fresnel : vec3(0.0);
}

const uint kAlbedoSamples = 34, kAlbedoStep = 21;  // lobe_boxes.h

/// lobe_boxes.h: lobeAlbedo, of those that are wanted.
vec3 lobeAlbedo(GgxLobe lobe, bool wanted) {
  vec3 sum = vec3(0.0);
  for (uint i = wanted ? 0 : kAlbedoSamples; i < kAlbedoSamples; ++i) {
    float turn = 2.0 * kPi / float(kAlbedoSamples) * (float(i * kAlbedoStep % kAlbedoSamples) + 0.5);
    float left = 1.0 - (float(i) + 0.5) / float(kAlbedoSamples);
    vec3 halfVector = sampleVisibleNormal(lobe.view, lobe.alpha, vec2(cos(turn), sin(turn)), left);
    sum += reflectionWeight(lobe, 2.0 * dot(lobe.view, halfVector) * halfVector - lobe.view, halfVector);
  }
  return sum / float(kAlbedoSamples);
}

/// A direction by its angles: cosine and sine of theta, and the point of the unit circle below it.
struct Polar {
  float y, ring;
  vec2 around;
};

Polar polar(vec3 direction, vec2 aroundPole) {
  float ring = length(direction.xz);
  return Polar(direction.y, ring, ring > 0.0 ? direction.xz / ring : aroundPole);
}

/// Weighted moments of directions, of their angles from the mirror direction: of the angles themselves, floats would leave nothing
/// of a sharp lobe's spread.
struct LobeMoments {
  vec3 energy;
  float weight;
  float sine, versine;  // 1 - cosine
  float theta, thetaSquared;
};

float strength(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }  // math.h: luminance

void addDirection(inout LobeMoments m, Polar mirror, Polar direction, vec3 energy) {
  float w = strength(energy);
  float s = mirror.around.x * direction.around.y - mirror.around.y * direction.around.x;
  float c = dot(mirror.around, direction.around);
  float t = atan(direction.ring * mirror.y - direction.y * mirror.ring, direction.y * mirror.y + direction.ring * mirror.ring);
  m.energy += energy;
  m.weight += w;
  m.sine += w * s;
  m.versine += w * (c > 0.0 ? s * s / (1.0 + c) : 1.0 - c);
  m.theta += w * t;
  m.thetaSquared += w * t * t;
}

const float kLeastLobeSize = 1e-5;
const float kStripRatio = 2.0;  // lobe_boxes.h

/// lobe_boxes.cpp: boxOf. With S and Q the means of sine and 1 - cosine, the mean vector's length is sqrt(1 - (2 Q - Q^2 - S^2)).
Rectangle lobeRectangle(LobeMoments m, Polar mirror, float spread) {
  float s = m.sine / m.weight, versine = m.versine / m.weight;
  float missing = clamp(2.0 * versine - versine * versine - s * s, 0.0, 1.0);
  float q = missing / (1.0 + sqrt(1.0 - missing));
  float arc = sqrt(q * (6.0 + q * (1.8 + q * (kPi * kPi - 7.8)))) / kPi;
  float du = clamp(spread * arc, kLeastLobeSize, 1.0);
  float phi = atan(mirror.around.y, mirror.around.x) + atan(s, 1.0 - versine);

  float mean = m.theta / m.weight;
  float deviation = sqrt(max(m.thetaSquared / m.weight - mean * mean, 0.0));
  float extent = max(0.5 * spread * sqrt(12.0) * deviation / kPi, kLeastLobeSize);
  float centre = clamp((atan(mirror.ring, mirror.y) + mean) / kPi, 0.0, 1.0);
  float above = min(extent, centre), below = min(extent, 1.0 - centre);
  return Rectangle(fract(0.5 + phi / (2.0 * kPi) - 0.5 * du), du, Latitudes(centre - above, above + below, 1.0 - centre - below));
}

/// One of the lobe's boxes; energies are relative.
struct LobeBox {
  Rectangle rectangle;
  vec3 energy;
};

LobeBox lobeBox(GgxLobe lobe, uint j) {
  vec3 reflected = lobe.frame * vec3(-lobe.view.xy, lobe.view.z);
  Polar mirror = polar(reflected, vec2(1.0, 0.0));
  uint cells = lobe.alpha.x > kStripRatio * lobe.alpha.y ? kTableStripCells : kTableRoundCells, cell = cells + kLobeCellFloats * j;
  LobeMoments moments = LobeMoments(vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);
  for (uint i = 0; i < kLobeSamples; ++i) {
    uint at = cell + 2 + 3 * i;  // of the sample in the tables
    vec3 halfVector = sampleVisibleNormal(lobe.view, lobe.alpha, vec2(tableAt(at), tableAt(at + 1)), tableAt(at + 2));
    vec3 light = 2.0 * dot(lobe.view, halfVector) * halfVector - lobe.view;
    addDirection(moments, mirror, polar(lobe.frame * light, mirror.around), reflectionWeight(lobe, light, halfVector));
  }
  if (!(moments.weight > 0.0)) return LobeBox(Rectangle(0.0, 1.0, Latitudes(0.0, 1.0, 0.0)), vec3(0.0));
  return LobeBox(lobeRectangle(moments, mirror, tableAt(cell + 1)), moments.energy * tableAt(cell) / float(kLobeSamples));
}

#endif
