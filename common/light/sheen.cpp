// SPDX-License-Identifier: Apache-2.0
#include "common/light/sheen.h"

#include <cmath>

#include "common/light/albedo_nodes.h"

namespace boxlight::sheen {
namespace {

/// The paper's L(x), equation 3 and table 1; its parameters are interpolated by (1 - alpha)^2.
float fittedL(float x, float alpha) {
  const float t = (1.0f - alpha) * (1.0f - alpha);
  const float a = glm::mix(21.5473f, 25.3245f, t), b = glm::mix(3.82987f, 3.32435f, t);
  const float c = glm::mix(0.19823f, 0.16801f, t), d = glm::mix(-1.97760f, -1.27393f, t);
  const float e = glm::mix(-4.32054f, -4.85967f, t);
  return a / (1.0f + b * std::pow(x, c)) + d * x + e;
}

float lambda(float cosine, float alpha) {
  return cosine < 0.5f
             ? std::exp(fittedL(cosine, alpha))
             : std::exp(2.0f * fittedL(0.5f, alpha) - fittedL(std::max(1.0f - cosine, 0.0f), alpha));
}

}  // namespace

float distribution(vec3 half, float alpha) {
  const float sine2 = half.x * half.x + half.y * half.y;
  return (2.0f + 1.0f / alpha) * std::pow(sine2, 0.5f / alpha) / (2.0f * kPi);
}

float visibility(float nDotL, float nDotV, float alpha) {
  return 1.0f / ((1.0f + lambda(nDotV, alpha) + lambda(nDotL, alpha)) * 4.0f * nDotL * nDotV);
}

namespace {

/// Midpoints over half a turn and over the light's angle to the horizon, crowded there by a square: a smooth
/// sheen lives at the rim.
float integrate(float roughness, float nDotV) {
  constexpr uint32_t kRings = 48, kSectors = 16;
  const float alpha = alphaOf(roughness);
  const vec3 view = albedo_nodes::directionAt(nDotV);
  double sum = 0.0;
  for (uint32_t i = 0; i < kRings; ++i)
    for (uint32_t j = 0; j < kSectors; ++j) {
      const float t = (float(i) + 0.5f) / float(kRings), z = t * t, ring = std::sqrt(1.0f - z * z);
      const float phi = kPi * (float(j) + 0.5f) / float(kSectors);
      const vec3 light(ring * std::cos(phi), ring * std::sin(phi), z);
      const vec3 half = glm::normalize(view + light);
      sum += double(distribution(half, alpha) * visibility(z, view.z, alpha) * z) * 2.0 * t;
    }
  return std::min(float(sum * 2.0 * kPiDouble / (kRings * kSectors)), 1.0f);
}

std::vector<float> makeAlbedoNodes() {
  using namespace albedo_nodes;
  std::vector<float> nodes;
  for (uint32_t j = 0; j < kSize; ++j)
    for (uint32_t i = 0; i < kSize; ++i)
      nodes.push_back(integrate(parameterAt(i), std::max(parameterAt(j), 1e-4f)));
  return nodes;
}

}  // namespace

const std::vector<float>& albedoNodes() {
  static const std::vector<float> nodes = makeAlbedoNodes();
  return nodes;
}

float albedo(float roughness, float nDotV) { return albedo_nodes::bilinear(albedoNodes(), roughness, nDotV); }

}  // namespace boxlight::sheen
