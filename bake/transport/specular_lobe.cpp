// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/specular_lobe.h"

#include <cmath>

#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"

namespace boxlight {
namespace {

/// Media whose indices differ by less let light pass unbent; the density of refracted directions would
/// overflow.
constexpr float kMatchedIor = 1e-3f;

bool isMatched(float ior) { return ior > 0.0f && std::abs(ior - 1.0f) < kMatchedIor; }

vec3 mirrored(vec3 w) { return {w.x, w.y, -w.z}; }

/// KHR_materials_anisotropy: the rough axis is the tangent.
vec2 anisotropicAlpha(const MaterialSample& m) {
  const float alpha = ggx::alphaOf(m.roughness);
  return {glm::mix(alpha, 1.0f, m.anisotropy * m.anisotropy), alpha};
}

}  // namespace

SpecularLobe::SpecularLobe(const MaterialSample& m, const Fresnel& fresnel, vec3 wo,
                           const Interface& interface)
    : fresnel_(fresnel),
      wo_(wo),
      alpha_(anisotropicAlpha(m)),
      ior_(interface.ior),
      tint_(m.transmission * (1.0f - m.metallic) * m.baseColor),
      compensation_(1.0f) {
  const float roughness = m.anisotropy > 0.0f ? std::pow(alpha_.x * alpha_.y, 0.25f) : m.roughness;
  const vec2 ab = albedoTable().specular(roughness, wo.z);
  // Turquin, "Practical multiple scattering compensation for microfacet models", 2019, equation 16.
  if (m.multipleScattering) compensation_ += fresnel.f0() * (1.0f / std::max(ab.x + ab.y, 1e-3f) - 1.0f);
  reflectedAlbedo_ = compensation_ * (fresnel.f0() * ab.x + fresnel.f90() * ab.y);
  transmittedAlbedo_ =
      tint_ * (ab.x * (1.0f - fresnel.dielectricF0()) + ab.y * (1.0f - fresnel.dielectricF90()));
}

float SpecularLobe::reflectProbability(float vDotH) const {
  if (!transmits()) return 1.0f;
  const float reflected = luminance(compensation_ * fresnel_.reflected(vDotH));
  const float transmitted = luminance(tint_) * (1.0f - fresnel_.dielectric(vDotH));
  return transmitted > 0.0f ? reflected / (reflected + transmitted) : 1.0f;
}

LobeValue SpecularLobe::evaluate(vec3 wi) const {
  if (wo_.z <= 0.0f || wi.z == 0.0f) return {};
  if (wi.z > 0.0f) return reflect(wi);
  if (!transmits() || isMatched(ior_)) return {};
  return ior_ > 0.0f ? refract(wi) : transmitThin(wi);
}

vec3 halfVector(vec3 a, vec3 b) {
  const vec3 sum = a + b;
  const vec2 difference = vec2(b) - vec2(a);
  const float length2 = glm::dot(difference, difference);
  if (length2 < 1.0f) return glm::normalize(sum);
  // |b_t|^2 - |a_t|^2 = a.z^2 - b.z^2, and a_t x b_t, instead of the cancelling a_t + b_t
  const float along = (a.z - b.z) * sum.z / length2, across = 2.0f * (a.x * b.y - a.y * b.x) / length2;
  return glm::normalize(vec3(along * difference + across * vec2(difference.y, -difference.x), sum.z));
}

LobeValue SpecularLobe::reflect(vec3 wi) const {
  const vec3 half = halfVector(wo_, wi);
  const float vDotH = glm::dot(wo_, half);
  const float microfacets = ggx::distribution(half, alpha_) * ggx::visibility(wi, wo_, alpha_) * wi.z;
  const float density = ggx::visibleNormalDensity(wo_, half, alpha_) / (4.0f * vDotH);
  return {compensation_ * fresnel_.reflected(vDotH) * microfacets, density * reflectProbability(vDotH)};
}

LobeValue SpecularLobe::transmitThin(vec3 wi) const {
  const vec3 above = mirrored(wi), half = halfVector(wo_, above);
  const float vDotH = glm::dot(wo_, half);
  // D G1(v) G1(l) / (4 n.v) = density of the mirrored direction times G1(l)
  const float density = ggx::visibleNormalDensity(wo_, half, alpha_) / (4.0f * vDotH);
  const float passed = (1.0f - fresnel_.dielectric(vDotH)) * ggx::masking(above, alpha_);
  return {tint_ * (passed * density), density * (1.0f - reflectProbability(vDotH))};
}

LobeValue SpecularLobe::refract(vec3 wi) const {
  vec3 half = wo_ + ior_ * wi;
  const float length = glm::length(half);
  if (length == 0.0f) return {};
  half *= (half.z > 0.0f ? 1.0f : -1.0f) / length;
  const float vDotH = glm::dot(wo_, half), lDotH = glm::dot(wi, half);
  if (vDotH <= 0.0f || lDotH >= 0.0f) return {};
  const float root = vDotH + ior_ * lDotH;
  const float jacobian =
      ior_ * ior_ * -lDotH / (root * root);  // steradian of half vector per steradian of wi
  const float density = ggx::visibleNormalDensity(wo_, half, alpha_) * jacobian;
  const float passed = (1.0f - fresnel_.dielectric(vDotH)) * ggx::masking(mirrored(wi), alpha_);
  return {tint_ * (passed * density), density * (1.0f - reflectProbability(vDotH))};
}

LobeSample SpecularLobe::sample(float choice, vec2 random) const {
  const vec3 half = ggx::sampleVisibleNormal(wo_, alpha_, random);
  const float vDotH = glm::dot(wo_, half), reflected = reflectProbability(vDotH);
  if (choice < reflected) return onSide(glm::reflect(-wo_, half), 1.0f);
  if (ior_ == 0.0f) return onSide(mirrored(glm::reflect(-wo_, half)), -1.0f);
  if (isMatched(ior_))
    return {-wo_, true, tint_ * ((1.0f - fresnel_.dielectric(vDotH)) / (1.0f - reflected))};
  return onSide(glm::refract(-wo_, half, 1.0f / ior_), -1.0f);
}

}  // namespace boxlight
