// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/pixel_model.h"

#include <cmath>

#include "common/light/directional_albedo.h"
#include "common/light/sheen.h"
#include "common/light/thin_film.h"

namespace boxlight {
namespace {

dvec3 toDvec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
double largest(dvec3 v) { return std::max({v.x, v.y, v.z}); }

double effectiveRoughness(const asset::Material& m, const asset::MaterialExtension& x) {
  const double alpha = double(m.roughness) * m.roughness, strength = x.anisotropy;
  const double alongTangent = alpha + (1.0 - alpha) * strength * strength;
  return strength > 0.0 ? std::pow(alongTangent * alpha, 0.25) : double(m.roughness);
}

dvec3 underFilm(const asset::MaterialExtension& x, double nDotV, dvec3 bare) {
  if (x.iridescence == 0.0f) return bare;
  const Rgb film = thinFilmReflectance(float(nDotV), x.iridescenceIor, x.iridescenceThickness[1], Rgb(bare));
  return glm::mix(bare, dvec3(schlickF0(film, float(nDotV))), double(x.iridescence));
}

dvec3 dielectricF0(const asset::Material& m, const asset::MaterialExtension& x) {
  const double ior = x.ior, d0 = ior == 0.0 ? 1.0 : std::pow((ior - 1.0) / (ior + 1.0), 2);
  return double(m.specular) * glm::min(d0 * toDvec3(m.specularColor), dvec3(1.0));
}

dvec3 baseColorOf(const asset::Material& m) { return {m.baseColor[0], m.baseColor[1], m.baseColor[2]}; }

}  // namespace

Rgb baseFresnel(const asset::Material& m, const asset::MaterialExtension& x, float vDotH) {
  const auto layer = [&](Rgb f0, float f90) {
    const Rgb bare = glm::mix(f0, Rgb(f90), std::pow(1 - vDotH, 5.0f));
    if (x.iridescence == 0.0f) return bare;
    const Rgb film = thinFilmReflectance(vDotH, x.iridescenceIor, x.iridescenceThickness[1], f0);
    return glm::mix(bare, film, x.iridescence);
  };
  return glm::mix(layer(Rgb(dielectricF0(m, x)), m.specular), layer(Rgb(baseColorOf(m)), 1), m.metallic);
}

PixelFactors pixelFactors(const asset::Material& m, const asset::MaterialExtension& x, double nDotV,
                          double coatNDotV) {
  const dvec3 baseColor = baseColorOf(m);
  PixelFactors f;
  if (m.flags & asset::kUnlit) {
    f.emission = baseColor;
    return f;
  }
  const double specular = m.specular, metallic = m.metallic;
  const dvec3 dielectric = underFilm(x, nDotV, dielectricF0(m, x));
  const dvec3 f0 = glm::mix(dielectric, underFilm(x, nDotV, baseColor), metallic);
  const double f90 = glm::mix(specular, 1.0, metallic), strongest = largest(dielectric);
  const glm::dvec2 ab = albedoTable().specular(float(effectiveRoughness(m, x)), float(nDotV));
  dvec3 reflected = f0 * ab.x + f90 * ab.y;
  f.albedo = ab, f.reflected = reflected;
  if (m.flags & asset::kMultipleScattering) reflected *= 1.0 + f0 * (1.0 / (ab.x + ab.y) - 1.0);
  const dvec3 through =
      x.transmission * (1.0 - metallic) * baseColor * (ab.x * (1.0 - strongest) + ab.y * (1.0 - specular));
  const double s = albedoTable().diffuseFresnel(float(nDotV));
  const double kd = 1.0 - (strongest + (specular - strongest) * s);
  const dvec3 sheenColor = toDvec3(x.sheenColor);
  const double sheenAlbedo = sheen::albedo(x.sheenRoughness, float(nDotV));
  const double underSheen = 1.0 - largest(sheenColor) * sheenAlbedo;
  const double coat = x.clearcoat * (0.04 + 0.96 * std::pow(1.0 - coatNDotV, 5));
  const glm::dvec2 coatAb = albedoTable().specular(x.clearcoatRoughness, float(coatNDotV));

  const double scattered = (1.0 - coat) * underSheen * kd * (1.0 - metallic) * (1.0 - double(x.transmission));
  f.diffuse = scattered * (1.0 - double(x.diffuseTransmission)) * baseColor;
  f.transmitted = scattered * double(x.diffuseTransmission) * toDvec3(x.diffuseTransmissionColor);
  f.base = (1.0 - coat) * underSheen * reflected;
  f.coat = dvec3(coat * (coatAb.x + coatAb.y));
  f.glossy = (1.0 - coat) * (underSheen * through + sheenColor * sheenAlbedo) + f.base + f.coat;
  f.emission = (1.0 - coat) * toDvec3(x.emissive);
  return f;
}

}  // namespace boxlight
