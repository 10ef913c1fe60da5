// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/fresnel.h"

#include <cmath>

#include "common/light/ggx.h"
#include "common/light/thin_film.h"

namespace boxlight {
namespace {

/// At normal incidence, KHR_materials_ior; an index of 0 stands for complete reflection.
float reflectanceOf(float ior) {
  const float amplitude = (ior - 1.0f) / (ior + 1.0f);
  return amplitude * amplitude;
}

constexpr float kTotal = -1.0f;  ///< in place of a cosine: total internal reflection

}  // namespace

Fresnel::Fresnel(const MaterialSample& m, const Interface& interface, float nDotV)
    : conductor_(m.baseColor),
      specular_(m.specular),
      metallic_(m.metallic),
      ior_(interface.ior > 0.0f ? interface.ior : 1.0f),
      film_(interface.inside || m.iridescenceThickness <= 0.0f ? 0.0f : m.iridescence),
      filmIor_(m.iridescenceIor),
      filmThickness_(m.iridescenceThickness),
      f90_(glm::mix(m.specular, 1.0f, m.metallic)) {
  const float normal = reflectanceOf(interface.ior > 0.0f ? interface.ior : m.ior);
  dielectric_ = m.specular * glm::min(normal * m.specularColor, Rgb(1.0f));
  Rgb dielectric = dielectric_, conductor = conductor_;
  if (film_ > 0.0f) {
    const auto stand = [&](Rgb bare) {
      const Rgb film = thinFilmReflectance(nDotV, filmIor_, filmThickness_, bare);
      return glm::mix(bare, schlickF0(film, nDotV), film_);
    };
    dielectric = stand(dielectric);
    conductor = stand(conductor);
  }
  f0_ = glm::mix(dielectric, conductor, metallic_);
  dielectricF0_ = maxComponent(dielectric);
}

float Fresnel::weight(float vDotH) const {
  if (ior_ >= 1.0f) return ggx::schlickWeight(vDotH);
  const float sine2 = (1.0f - vDotH * vDotH) / (ior_ * ior_);
  return sine2 >= 1.0f ? kTotal : ggx::schlickWeight(std::sqrt(1.0f - sine2));
}

Rgb Fresnel::withFilm(Rgb bare, Rgb baseF0, float vDotH) const {
  if (film_ <= 0.0f) return bare;
  return glm::mix(bare, thinFilmReflectance(vDotH, filmIor_, filmThickness_, baseF0), film_);
}

Rgb Fresnel::dielectricRgb(float vDotH) const {
  const float schlick = weight(vDotH);
  if (schlick == kTotal) return Rgb(1.0f);
  return withFilm(glm::mix(dielectric_, Rgb(specular_), schlick), dielectric_, vDotH);
}

Rgb Fresnel::reflected(float vDotH) const {
  if (metallic_ <= 0.0f) return dielectricRgb(vDotH);
  const Rgb bare = glm::mix(conductor_, Rgb(1.0f), ggx::schlickWeight(vDotH));
  return glm::mix(dielectricRgb(vDotH), withFilm(bare, conductor_, vDotH), metallic_);
}

float Fresnel::dielectric(float vDotH) const { return maxComponent(dielectricRgb(vDotH)); }

}  // namespace boxlight
