// SPDX-License-Identifier: Apache-2.0
#include "common/light/directional_albedo.h"

#include <cmath>

#include "common/light/albedo_nodes.h"
#include "common/light/ggx.h"

namespace boxlight {
namespace {

// Midpoints over half a turn and over the cap: errors of the integrals below 1e-3.
constexpr uint32_t kTurns = 16, kHeights = 24;

using albedo_nodes::directionAt;

/// (A, B) as means over visible normals, of which D V n.l dl is G2 / G1(v) times their density. Midpoints
/// crowd, by a cube, at the rim of the cap, where the steep normals of a smooth surface are.
vec2 integrateSpecular(float roughness, float nDotV) {
  const float alpha = ggx::alphaOf(roughness), lambdaView = ggx::lambda(nDotV, alpha);
  const vec3 view = directionAt(nDotV);
  vec2 sum(0.0f);
  float measure = 0.0f;
  for (uint32_t i = 0; i < kTurns; ++i)
    for (uint32_t j = 0; j < kHeights; ++j) {
      const float turn = (float(i) + 0.5f) / float(2 * kTurns), t = (float(j) + 0.5f) / float(kHeights);
      const float crowding = t * t;
      measure += crowding;
      const vec3 half = ggx::sampleVisibleNormal(view, alpha, {turn, 1.0f - t * t * t});
      const float vDotH = glm::dot(view, half), nDotL = 2.0f * vDotH * half.z - view.z;
      if (nDotL <= 0.0f) continue;
      // G2 / G1(v) = (1 + Lambda(v)) / (1 + Lambda(v) + Lambda(l))
      const float shadowing = (1.0f + lambdaView) / (1.0f + lambdaView + ggx::lambda(nDotL, alpha));
      const float fresnel = ggx::schlickWeight(vDotH);
      sum += crowding * shadowing * vec2(1.0f - fresnel, fresnel);
    }
  return sum / measure;
}

/// Midpoints over cos^2 theta, which the cosine makes uniform, and over half a turn.
float integrateFresnel(float nDotV) {
  constexpr uint32_t kRings = 64, kSectors = 64;
  const vec3 view = directionAt(nDotV);
  double sum = 0.0;
  for (uint32_t i = 0; i < kRings; ++i)
    for (uint32_t j = 0; j < kSectors; ++j) {
      const float z = std::sqrt((float(i) + 0.5f) / float(kRings)), ring = std::sqrt(1.0f - z * z);
      const float phi = kPi * (float(j) + 0.5f) / float(kSectors);
      const vec3 light(ring * std::cos(phi), ring * std::sin(phi), z);
      sum +=
          ggx::schlickWeight(std::sqrt(0.5f + 0.5f * glm::dot(view, light)));  // v.h = cos of half the angle
    }
  return float(sum / (kRings * kSectors));
}

AlbedoTable makeTable() {
  using namespace albedo_nodes;
  AlbedoTable table;
  for (uint32_t j = 0; j < kSize; ++j) {
    const float nDotV = std::max(parameterAt(j), 1e-4f);  // the limit, where Lambda is still finite
    for (uint32_t i = 0; i < kSize; ++i) {
      table.specularNodes.push_back(integrateSpecular(parameterAt(i), nDotV));
    }
    table.fresnelNodes.push_back(integrateFresnel(nDotV));
  }
  return table;
}

}  // namespace

vec2 AlbedoTable::specular(float roughness, float nDotV) const {
  return albedo_nodes::bilinear(specularNodes, roughness, nDotV);
}

float AlbedoTable::diffuseFresnel(float nDotV) const {
  const albedo_nodes::Node y(nDotV);
  return glm::mix(fresnelNodes[y.index], fresnelNodes[y.index + 1], y.fraction);
}

const AlbedoTable& albedoTable() {
  static const AlbedoTable table = makeTable();
  return table;
}

}  // namespace boxlight
