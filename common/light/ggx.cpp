// SPDX-License-Identifier: Apache-2.0
#include "common/light/ggx.h"

#include <cmath>

namespace boxlight::ggx {
namespace {

/// (n.x) (1 + 2 Lambda(x)): stays positive at grazing angles, where Lambda grows without bound.
float stretchedCosine(float cosine, float alpha) {
  const float a2 = alpha * alpha;
  return std::sqrt(a2 + (1.0f - a2) * cosine * cosine);
}

/// The same for a direction: its length after the surface is stretched.
float stretchedLength(vec3 w, vec2 alpha) { return glm::length(vec3(alpha * vec2(w), w.z)); }

}  // namespace

float distribution(vec3 half, float alpha) {
  if (half.z <= 0.0f) return 0.0f;
  const float a2 = alpha * alpha;
  const float slope = half.x * half.x + half.y * half.y + a2 * half.z * half.z;
  return a2 / (kPi * slope * slope);
}

float lambda(float cosine, float alpha) { return 0.5f * (stretchedCosine(cosine, alpha) / cosine - 1.0f); }

float masking(float cosine, float alpha) { return 2.0f * cosine / (cosine + stretchedCosine(cosine, alpha)); }

float visibility(float nDotL, float nDotV, float alpha) {
  return 0.5f / (nDotL * stretchedCosine(nDotV, alpha) + nDotV * stretchedCosine(nDotL, alpha));
}

float distribution(vec3 half, vec2 alpha) {
  if (half.z <= 0.0f) return 0.0f;
  const float slope = half.x * half.x * (alpha.y / alpha.x) + half.y * half.y * (alpha.x / alpha.y) +
                      half.z * half.z * alpha.x * alpha.y;
  return alpha.x * alpha.y / (kPi * slope * slope);
}

float lambda(vec3 direction, vec2 alpha) {
  return 0.5f * (stretchedLength(direction, alpha) / direction.z - 1.0f);
}

float masking(vec3 direction, vec2 alpha) {
  return 2.0f * direction.z / (direction.z + stretchedLength(direction, alpha));
}

float visibility(vec3 light, vec3 view, vec2 alpha) {
  return 0.5f / (light.z * stretchedLength(view, alpha) + view.z * stretchedLength(light, alpha));
}

float schlickWeight(float vDotH) {
  const float m = std::clamp(1.0f - vDotH, 0.0f, 1.0f);
  const float m2 = m * m;
  return m2 * m2 * m;
}

vec3 sampleVisibleNormal(vec3 view, vec2 alpha, vec2 random) {
  const vec3 stretched = glm::normalize(vec3(alpha * vec2(view), view.z));
  // Half is `stretched` plus a uniform point of the cap of the unit sphere above -stretched.z. Its height is
  // found before the point's, so that it never cancels to zero.
  const float height = (1.0f - random.y) * (1.0f + stretched.z), z = height - stretched.z;
  const float ring = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f));
  const float phi = 2.0f * kPi * random.x;
  const vec2 tangential = vec2(ring * std::cos(phi), ring * std::sin(phi)) + vec2(stretched);
  return glm::normalize(vec3(alpha * tangential, height));
}

float visibleNormalDensity(vec3 view, vec3 half, vec2 alpha) {
  const float vDotH = std::max(glm::dot(view, half), 0.0f);
  return 2.0f * vDotH * distribution(half, alpha) / (view.z + stretchedLength(view, alpha));
}

}  // namespace boxlight::ggx
