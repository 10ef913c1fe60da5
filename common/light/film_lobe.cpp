// SPDX-License-Identifier: Apache-2.0
#include "common/light/film_lobe.h"

#include <cmath>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

/// Of weights: where a lobe sees fewer, the line is flatter than its two points.
constexpr float kLeastWidth = 0.01f;

struct Spread {
  float mean = 0, deviation = 0;
};

Spread spreadOfCosines(const GgxLobe& lobe) {
  const vec3 view(glm::dot(lobe.view, lobe.tangent), glm::dot(lobe.view, lobe.bitangent),
                  glm::dot(lobe.view, lobe.normal));
  float sum = 0, squares = 0;
  for (int i = 0; i < 4; ++i) {
    const float cosine = glm::dot(view, ggx::sampleVisibleNormal(view, lobe.alpha, {0.25f * float(i), 0.5f}));
    sum += cosine;
    squares += cosine * cosine;
  }
  const float mean = sum / 4;
  return {mean, std::sqrt(std::max(squares / 4 - mean * mean, 0.0f))};
}

}  // namespace

void fitFresnel(GgxLobe& lobe, const std::function<Rgb(float)>& fresnel) {
  const auto [mean, deviation] = spreadOfCosines(lobe);
  const float low = std::clamp(mean - deviation, 0.0f, 1.0f), high = std::clamp(mean + deviation, 0.0f, 1.0f);
  const Rgb atLow = fresnel(low), atHigh = fresnel(high);
  const float lowWeight = ggx::schlickWeight(low), highWeight = ggx::schlickWeight(high);
  const Rgb slope = (atLow - atHigh) / std::max(lowWeight - highWeight, kLeastWidth);
  lobe.f0 = 0.5f * (atLow + atHigh - (lowWeight + highWeight) * slope);
  lobe.f90 = lobe.f0 + slope;
  lobe.filmed = true;
}

Rgb filmedAlbedo(const GgxLobe& lobe, vec2 albedo) {
  const float whole = albedo.x + albedo.y;
  return glm::clamp(lobe.f0 * albedo.x + lobe.f90 * albedo.y, kLeastFilmed * whole, whole);
}

}  // namespace boxlight
