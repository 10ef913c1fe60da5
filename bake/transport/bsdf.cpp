// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/bsdf.h"

#include <cmath>

#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"

namespace boxlight {

Bsdf::Bsdf(const MaterialSample& m) : roughness_(m.roughness), alpha_(ggx::alphaOf(m.roughness)) {
  const Rgb dielectric = glm::min(0.04f * m.specularColor, Rgb(1.0f));
  diffuseAlbedo_ = (1.0f - m.metallic) * m.baseColor;
  f0_ = glm::mix(m.specular * dielectric, m.baseColor, m.metallic);
  f90_ = glm::mix(m.specular, 1.0f, m.metallic);
  dielectricF0_ = m.specular * maxComponent(dielectric);
  dielectricF90_ = m.specular;
}

Bsdf::Value Bsdf::evaluate(vec3 wo, vec3 wi) const {
  Value value;
  if (wo.z <= 0.0f || wi.z <= 0.0f) return value;
  const vec3 half = glm::normalize(wo + wi);
  const float schlick = ggx::schlickWeight(glm::dot(wo, half));
  if (hasDiffuse()) {
    const float transmitted = 1.0f - glm::mix(dielectricF0_, dielectricF90_, schlick);
    value.diffuse = diffuseAlbedo_ * (transmitted * wi.z / kPi);
  }
  if (hasGlossy()) {
    const float microfacets = ggx::distribution(half, alpha_) * ggx::visibility(wi.z, wo.z, alpha_);
    value.glossy = glm::mix(f0_, Rgb(f90_), schlick) * (microfacets * wi.z);
  }
  return value;
}

Rgb Bsdf::glossyAlbedo(float nDotV) const {
  const vec2 ab = albedoTable().specular(roughness_, nDotV);
  return f0_ * ab.x + f90_ * ab.y;
}

float Bsdf::glossyProbability(vec3 wo) const {
  if (!hasDiffuse()) return 1.0f;
  if (!hasGlossy()) return 0.0f;
  const float glossy = luminance(glossyAlbedo(wo.z)), diffuse = luminance(diffuseAlbedo_);
  return glossy / (glossy + diffuse);
}

vec3 Bsdf::sampleGlossy(vec3 wo, vec2 random, Rgb& weight) const {
  const vec3 half = ggx::sampleVisibleNormal(wo, alpha_, random);
  const vec3 wi = glm::reflect(-wo, half);
  weight = Rgb(0.0f);
  if (wo.z <= 0.0f || wi.z <= 0.0f) return wi;
  // f cos / density = F G2 / G1: D cancels, so the weight stays exact however narrow the lobe is.
  const float vDotH = glm::dot(wo, half);
  const float shadowing =
      ggx::visibility(wi.z, wo.z, alpha_) * 4.0f * wi.z * wo.z / ggx::masking(wo.z, alpha_);
  weight = glm::mix(f0_, Rgb(f90_), ggx::schlickWeight(vDotH)) * shadowing;
  return wi;
}

vec3 Bsdf::sample(vec3 wo, float choice, vec2 random) const {
  if (choice < glossyProbability(wo)) return glm::reflect(-wo, ggx::sampleVisibleNormal(wo, alpha_, random));
  const float radius = std::sqrt(random.x), phi = 2.0f * kPi * random.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0f, 1.0f - random.x))};
}

float Bsdf::density(vec3 wo, vec3 wi) const {
  if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
  const float glossy = glossyProbability(wo);
  float result = (1.0f - glossy) * wi.z / kPi;
  if (glossy > 0.0f) {
    const vec3 half = glm::normalize(wo + wi);
    result += glossy * ggx::visibleNormalDensity(wo, half, alpha_) / (4.0f * glm::dot(wo, half));
  }
  return result;
}

}  // namespace boxlight
