// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/bsdf.h"

#include <bit>
#include <cmath>

#include "bake/transport/warp.h"
#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"
#include "common/light/sheen.h"
#include "common/light/view_sphere.h"

namespace boxlight {
namespace {

constexpr float kMinimumCoatCosine =
    1e-3f;                        ///< a coat's own normal is bent towards wo, like the shading normal
constexpr float kCoatF0 = 0.04f;  ///< KHR_materials_clearcoat: an index of 1.5

uint32_t indexOf(Lobes lobe) { return uint32_t(std::countr_zero(uint32_t(lobe))); }

}  // namespace

Bsdf::Bsdf(const MaterialSample& m, vec3 wo, const Interface& interface, vec3 coatNormal)
    : fresnel_(m, interface, wo.z), specular_(m, fresnel_, wo, interface), wo_(wo) {
  if (m.unlit) {
    emission_ = m.baseColor;
    return;
  }
  float base = 1.0f;
  if (m.clearcoat > 0.0f && !interface.inside) {
    coatNormal_ = raiseAboveHorizon(coatNormal, wo, kMinimumCoatCosine);
    orthonormalBasis(coatNormal_, coatTangent_, coatBitangent_);
    const float nDotV = glm::dot(coatNormal_, wo);
    const vec2 ab = albedoTable().specular(m.clearcoatRoughness, nDotV);
    coatAlpha_ = ggx::alphaOf(m.clearcoatRoughness);
    coatAlbedo_ = ab.x + ab.y;
    weight_[indexOf(kCoat)] = Rgb(m.clearcoat * glm::mix(kCoatF0, 1.0f, ggx::schlickWeight(nDotV)));
    base -= weight_[indexOf(kCoat)].x;
  }
  emission_ = base * m.emission;
  if (maxComponent(m.sheenColor) > 0.0f && !interface.inside) {
    sheenAlpha_ = sheen::alphaOf(m.sheenRoughness);
    sheenAlbedo_ = sheen::albedo(m.sheenRoughness, wo.z);
    weight_[indexOf(kSheen)] = base * m.sheenColor;
    base *= 1.0f - maxComponent(m.sheenColor) * sheenAlbedo_;
  }
  const float scattered = base * (1.0f - m.metallic) * (1.0f - m.transmission);
  weight_[indexOf(kDiffuse)] = scattered * (1.0f - m.diffuseTransmission) * m.baseColor;
  weight_[indexOf(kDiffuseTransmit)] = scattered * m.diffuseTransmission * m.diffuseTransmissionColor;
  if (specular_.isPresent()) weight_[indexOf(kSpecular)] = Rgb(base);
  chooseProbabilities();
}

void Bsdf::chooseProbabilities() {
  const std::array<Rgb, kCount> albedo = {Rgb(1.0f), Rgb(1.0f), specular_.albedo(), Rgb(sheenAlbedo_),
                                          Rgb(coatAlbedo_)};
  for (size_t i = 0; i < kCount; ++i) probability_[i] = luminance(weight_[i] * albedo[i]);
}

bool Bsdf::has(uint32_t lobes) const {
  for (uint32_t i = 0; i < kCount; ++i)
    if ((lobes >> i & 1) && probability_[i] > 0.0f) return true;
  return false;
}

uint32_t Bsdf::viewDependentCount() const {
  return uint32_t(has(kSpecular)) + uint32_t(has(kCoat)) + unmirroredCount();
}

uint32_t Bsdf::unmirroredCount() const {
  return uint32_t(has(kSpecular) && specular_.transmits()) + uint32_t(has(kSheen));
}

float Bsdf::sharpestAlpha() const {
  const float base = has(kSpecular) ? std::min(alpha().x, alpha().y) : 1.0f;
  return has(kCoat) ? std::min(base, coatAlpha_) : base;
}

Rgb Bsdf::viewDependentAlbedo() const {
  return weight_[indexOf(kSpecular)] * specular_.albedo() + weight_[indexOf(kSheen)] * sheenAlbedo_ +
         weight_[indexOf(kCoat)] * coatAlbedo_;
}

LobeValue Bsdf::evaluate(vec3 wi, uint32_t lobes) const {
  LobeValue sum;
  float total = 0.0f;
  for (uint32_t i = 0; i < kCount; ++i) {
    if (!(lobes >> i & 1) || probability_[i] <= 0.0f) continue;
    total += probability_[i];
    sum.add(evaluateLobe(i, wi), weight_[i], probability_[i]);
  }
  if (total > 0.0f) sum.density /= total;
  return sum;
}

LobeSample Bsdf::sample(float choice, vec2 random, uint32_t lobes) const {
  float total = 0.0f;
  for (uint32_t i = 0; i < kCount; ++i)
    if (lobes >> i & 1) total += probability_[i];
  float left = choice * total;
  for (uint32_t i = kCount; i-- > 0;) {
    if (!(lobes >> i & 1) || probability_[i] <= 0.0f) continue;
    if (left >= probability_[i] && has(lobes & ((1u << i) - 1))) {
      left -= probability_[i];
      continue;
    }
    LobeSample drawn = sampleLobe(i, std::clamp(left / probability_[i], 0.0f, 0x1.fffffep-1f), random);
    if (drawn.delta) drawn.weight *= weight_[i] * (total / probability_[i]);
    if (drawn.lost != Rgb(0.0f)) drawn.lost *= weight_[i] / probability_[i] * total;
    return drawn;
  }
  return {};
}

LobeValue Bsdf::evaluateLobe(uint32_t index, vec3 wi) const {
  switch (1u << index) {
    case kDiffuse:
      return lambert(wi, 1.0f);
    case kDiffuseTransmit:
      return lambert(wi, -1.0f);
    case kSpecular:
      return specular_.evaluate(wi);
    case kSheen:
      return sheen(wi);
    default:
      return coat(wi);
  }
}

LobeValue Bsdf::lambert(vec3 wi, float side) const {
  wi.z *= side;
  if (wi.z <= 0.0f) return {};
  const float vDotH = glm::dot(wo_, glm::normalize(wo_ + wi));
  return {Rgb((1.0f - fresnel_.dielectric(vDotH)) * wi.z / kPi), wi.z / kPi};
}

LobeValue Bsdf::sheen(vec3 wi) const {
  if (wi.z <= 0.0f) return {};
  const vec3 half = glm::normalize(wo_ + wi);
  return {Rgb(sheen::distribution(half, sheenAlpha_) * sheen::visibility(wi.z, wo_.z, sheenAlpha_) * wi.z),
          kUniformHemisphereDensity};
}

LobeValue Bsdf::coat(vec3 wi) const {
  const float nDotL = glm::dot(wi, coatNormal_), nDotV = glm::dot(wo_, coatNormal_);
  if (wi.z <= 0.0f || nDotL <= 0.0f) return {};
  const vec3 half = glm::normalize(wo_ + wi);
  const vec3 local(glm::dot(half, coatTangent_), glm::dot(half, coatBitangent_), glm::dot(half, coatNormal_));
  const vec3 view(glm::dot(wo_, coatTangent_), glm::dot(wo_, coatBitangent_), nDotV);
  return {Rgb(ggx::distribution(local, coatAlpha_) * ggx::visibility(nDotL, nDotV, coatAlpha_) * nDotL),
          ggx::visibleNormalDensity(view, local, coatAlpha_) / (4.0f * glm::dot(wo_, half))};
}

/// G2 / G1: what a reflection by a visible normal weighs.
float Bsdf::coatShadowing(float nDotL, float nDotV) const {
  const float masked = 1.0f + ggx::lambda(nDotV, coatAlpha_);
  return masked / (masked + ggx::lambda(nDotL, coatAlpha_));
}

LobeSample Bsdf::sampleLobe(uint32_t index, float choice, vec2 random) const {
  switch (1u << index) {
    case kDiffuse:
      return {cosineDirection(random)};
    case kDiffuseTransmit:
      return {cosineDirection(random) * vec3(1, 1, -1)};
    case kSpecular:
      return specular_.sample(choice, random);
    case kSheen:
      return {uniformDirection(random)};
    default: {
      const vec3 view(glm::dot(wo_, coatTangent_), glm::dot(wo_, coatBitangent_), glm::dot(wo_, coatNormal_));
      const vec3 half = ggx::sampleVisibleNormal(view, coatAlpha_, random);
      const vec3 wi = glm::reflect(-view, half);
      if (wi.z <= 0.0f) return {};
      LobeSample drawn = onSide(wi.x * coatTangent_ + wi.y * coatBitangent_ + wi.z * coatNormal_, 1.0f);
      if (drawn.wi == vec3(0.0f)) drawn.lost = Rgb(coatShadowing(wi.z, view.z));
      return drawn;
    }
  }
}

}  // namespace boxlight
