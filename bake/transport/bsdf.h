// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/material.h"
#include "common/base/math.h"

namespace boxlight {

/// glTF 2.0 metallic-roughness with KHR_materials_specular (the specification's appendix B.2 and B.3), at one
/// point, in the local frame (z = shading normal, both directions away from the surface):
///   f = mix(fresnel_mix(Lambert, GGX), conductor, metallic)
///     = baseColor (1 - metallic)/pi (1 - F_d(v.h)) + D V F(v.h)
/// F is Schlick's from f0 to f90; F_d is the dielectric's largest channel. GGX with height-correlated Smith
/// masking.
class Bsdf {
 public:
  explicit Bsdf(const MaterialSample& material);

  struct Value {
    Rgb diffuse{0.0f}, glossy{0.0f};
    Rgb sum() const { return diffuse + glossy; }
  };
  /// f * wi.z of both parts; zero unless wo.z > 0 and wi.z > 0.
  Value evaluate(vec3 wo, vec3 wi) const;
  /// A direction; it may lie below the horizon, where evaluate is zero. `choice` picks the part.
  vec3 sample(vec3 wo, float choice, vec2 random) const;
  /// The density of sample(), per steradian.
  float density(vec3 wo, vec3 wi) const;

  /// A direction from the GGX part alone and f cos / density of it; 0 below the horizon.
  vec3 sampleGlossy(vec3 wo, vec2 random, Rgb& weight) const;

  /// Directional albedo of the GGX part, by the table that the pixel multiplies back (directional_albedo.h).
  Rgb glossyAlbedo(float nDotV) const;

  const Rgb& diffuseAlbedo() const {
    return diffuseAlbedo_;
  }  ///< baseColor (1 - metallic), without its Fresnel factor
  const Rgb& f0() const { return f0_; }
  float alpha() const { return alpha_; }
  bool hasGlossy() const { return f90_ > 0.0f || maxComponent(f0_) > 0.0f; }
  bool hasDiffuse() const { return maxComponent(diffuseAlbedo_) > 0.0f; }

 private:
  float glossyProbability(vec3 wo) const;

  Rgb diffuseAlbedo_, f0_;
  float f90_;
  float dielectricF0_, dielectricF90_;  ///< of the diffuse part's Fresnel factor
  float roughness_, alpha_;
};

}  // namespace boxlight
