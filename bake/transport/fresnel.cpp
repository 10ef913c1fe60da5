// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/fresnel.h"

#include <cmath>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

/// At normal incidence, KHR_materials_ior; an index of 0 stands for complete reflection.
float reflectanceOf(float ior) {
  const float amplitude = (ior - 1.0f) / (ior + 1.0f);
  return amplitude * amplitude;
}

constexpr float kTotal = -1.0f;  ///< in place of a cosine: total internal reflection

}  // namespace

Fresnel::Fresnel(const MaterialSample& m, const Interface& interface)
    : metallic_(m.metallic), ior_(interface.ior > 0.0f ? interface.ior : 1.0f) {
  const float normal = reflectanceOf(interface.ior > 0.0f ? interface.ior : m.ior);
  const Rgb dielectric = glm::min(normal * m.specularColor, Rgb(1.0f));
  f0_ = glm::mix(m.specular * dielectric, m.baseColor, m.metallic);
  f90_ = glm::mix(m.specular, 1.0f, m.metallic);
  dielectricF0_ = m.specular * maxComponent(dielectric);
  dielectricF90_ = m.specular;
}

float Fresnel::weight(float vDotH) const {
  if (ior_ >= 1.0f) return ggx::schlickWeight(vDotH);
  const float sine2 = (1.0f - vDotH * vDotH) / (ior_ * ior_);
  return sine2 >= 1.0f ? kTotal : ggx::schlickWeight(std::sqrt(1.0f - sine2));
}

Rgb Fresnel::reflected(float vDotH) const {
  const float schlick = weight(vDotH);
  if (schlick != kTotal) return glm::mix(f0_, Rgb(f90_), schlick);
  const Rgb conductor = glm::mix(f0_, Rgb(f90_), ggx::schlickWeight(vDotH));
  return glm::mix(Rgb(1.0f), conductor, metallic_);
}

float Fresnel::dielectric(float vDotH) const {
  const float schlick = weight(vDotH);
  return schlick == kTotal ? 1.0f : glm::mix(dielectricF0_, dielectricF90_, schlick);
}

}  // namespace boxlight
