// SPDX-License-Identifier: Apache-2.0
#include "tests/cycles/cycles_closures.h"

#include <cmath>

#include "bake/transport/warp.h"
#include "common/light/ggx.h"

namespace boxlight::cycles {
namespace {

vec2 alphaOf(const MaterialSample& m) {
  const float alpha = ggx::alphaOf(m.roughness);
  return {glm::mix(alpha, 1.0f, m.anisotropy * m.anisotropy), alpha};
}

LobeValue lambert(Rgb colour, vec3 wi) {
  if (wi.z <= 0.0f) return {};
  return {colour * (wi.z / kPi), wi.z / kPi};
}

/// Without Fresnel term. D G1(o) / (4 n.o) is the density of the reflected direction.
LobeValue reflection(vec3 wo, vec3 wi, vec2 alpha) {
  if (wo.z <= 0.0f || wi.z <= 0.0f) return {};
  const vec3 half = glm::normalize(wo + wi);
  const float density = ggx::visibleNormalDensity(wo, half, alpha) / (4.0f * glm::dot(wo, half));
  return {Rgb(density * ggx::masking(wi, alpha)), density};
}

/// Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, equations 17 and 21
/// without the Fresnel term, in basic radiance. As Cycles does it, half vectors that face away from wo count,
/// too: they refract into directions that no ray can be bent into, which sampling never finds, but light
/// sampling does.
LobeValue refraction(vec3 wo, vec3 wi, vec2 alpha, float ior) {
  if (wo.z <= 0.0f || wi.z >= 0.0f) return {};
  const vec3 sum = wo + ior * wi;
  const float square = glm::dot(sum, sum);
  if (!(square > 0.0f)) return {};
  const vec3 half = (sum.z < 0.0f ? -sum : sum) / std::sqrt(square);
  const float density = ggx::masking(wo, alpha) * ggx::distribution(half, alpha) * ior * ior *
                        std::abs(glm::dot(wo, half) * glm::dot(wi, half)) / (wo.z * square);
  return {Rgb(density * ggx::masking(vec3(wi.x, wi.y, -wi.z), alpha)), density};
}

/// Fresnel's equations for unpolarised light; `ior` is that of the far side over the near side.
float dielectricReflectance(float cosine, float ior) {
  const float square = ior * ior - 1.0f + cosine * cosine;
  if (square <= 0.0f) return 1.0f;
  const float far = std::sqrt(square);  // ior times the refracted cosine
  const float s = (cosine - far) / (cosine + far);
  const float p = (ior * ior * cosine - far) / (ior * ior * cosine + far);
  return 0.5f * (s * s + p * p);
}

}  // namespace

Metal::Metal(const MaterialSample& m, vec3 wo, const Interface&, vec3)
    : wo_(wo), colour_(m.baseColor), alpha_(alphaOf(m)), lambert_(m.metallic == 0.0f) {}

LobeValue Metal::evaluate(vec3 wi) const {
  if (lambert_) return lambert(colour_, wi);
  LobeValue value = reflection(wo_, wi, alpha_);
  value.value *= colour_;
  return value;
}

LobeSample Metal::sample(float, vec2 random) const {
  if (lambert_) return {cosineDirection(random)};
  return {glm::reflect(-wo_, ggx::sampleVisibleNormal(wo_, alpha_, random))};
}

Glass::Glass(const MaterialSample& m, vec3 wo, const Interface& interface, vec3)
    : wo_(wo),
      colour_(m.baseColor),
      alpha_(alphaOf(m)),
      ior_(interface.ior),
      reflected_(ior_ > 0.0f ? dielectricReflectance(wo.z, ior_) : 0.0f) {}

LobeValue Glass::evaluate(vec3 wi) const {
  if (ior_ == 0.0f) return lambert(colour_, wi);
  LobeValue value;
  value.add(reflection(wo_, wi, alpha_), Rgb(reflected_), reflected_);
  value.add(refraction(wo_, wi, alpha_, ior_), Rgb(1.0f - reflected_), 1.0f - reflected_);
  return value;
}

LobeSample Glass::sample(float choice, vec2 random) const {
  if (ior_ == 0.0f) return {cosineDirection(random)};
  const vec3 half = ggx::sampleVisibleNormal(wo_, alpha_, random);
  if (choice < reflected_) return {glm::reflect(-wo_, half)};
  return {glm::refract(-wo_, half, 1.0f / ior_)};
}

}  // namespace boxlight::cycles
