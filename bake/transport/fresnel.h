// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/material.h"

namespace boxlight {

/// What a surface separates, seen from the side of wo.
struct Interface {
  float ior = 0;        ///< refractive index of the far side over the near side; 0 where nothing refracts
  bool inside = false;  ///< wo lies in the medium that the surface bounds
};

/// The Fresnel terms of glTF's appendix B: Schlick's from F0 to F90 by the half vector, mixed between
/// dielectric and conductor. Where the far side is optically thinner, Schlick's weight takes the cosine of
/// the refracted direction, and beyond the critical angle everything is reflected. A thin film (thin_film.h)
/// on the outside takes their place by its weight.
class Fresnel {
 public:
  /// `nDotV` is the cosine at which f0() stands in for a film.
  Fresnel(const MaterialSample& material, const Interface& interface, float nDotV);

  /// What the specular lobe reflects, per channel.
  Rgb reflected(float vDotH) const;
  /// The largest channel of the dielectric part: what keeps light from the diffuse and transmitting lobes.
  float dielectric(float vDotH) const;

  bool isFilmed() const { return film_ > 0.0f; }

  // As the pixel takes them for its albedo tables.
  const Rgb& f0() const { return f0_; }
  float f90() const { return f90_; }
  float dielectricF0() const { return dielectricF0_; }  ///< largest channel
  float dielectricF90() const { return specular_; }

 private:
  float weight(float vDotH) const;
  Rgb dielectricRgb(float vDotH) const;
  Rgb withFilm(Rgb bare, Rgb baseF0, float vDotH) const;

  Rgb dielectric_, conductor_;  ///< bare F0 of the two
  float specular_, metallic_, ior_;
  float film_, filmIor_, filmThickness_;
  Rgb f0_;
  float f90_, dielectricF0_;
};

}  // namespace boxlight
