// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/fresnel.h"

namespace boxlight {

/// f times the cosine of wi, and the density of sampling wi, per steradian.
struct LobeValue {
  Rgb value{0.0f};
  float density = 0;

  void add(const LobeValue& other, Rgb weight, float probability) {
    value += weight * other.value;
    density += probability * other.density;
  }
};

/// A direction drawn from a lobe; 0 if it left the lobe's side of the surface: that path ends. A `delta` goes
/// straight on: no density tells how likely it is, and `weight` is what value / density would be. So is
/// `lost`, of a direction that a coat with a normal of its own reflects into the surface.
struct LobeSample {
  vec3 wi{0.0f};
  bool delta = false;
  Rgb weight{0.0f}, lost{0.0f};
};

/// `wi` as a sample of a lobe on the side of that sign. On the other side another lobe's density would be
/// taken for its own, which would gain light.
inline LobeSample onSide(vec3 wi, float side) { return wi.z * side > 0.0f ? LobeSample{wi} : LobeSample{}; }

/// The unit vector halfway between two unit vectors above the horizon. Towards grazing angles its tilt comes
/// from their cosines, which are precise there, not from tangential parts that cancel.
vec3 halfVector(vec3 a, vec3 b);

/// Rough reflection and transmission by GGX microfacets, seen from wo (z is the shading normal, wo.z > 0):
///   reflection F D V with height-correlated masking, as glTF has it (appendix B);
///   transmission through a thin wall: the lobe (1 - F_d) D V mirrored to the other side
///   (KHR_materials_transmission); transmission into a medium: Walter et al., "Microfacet Models for
///   Refraction through Rough Surfaces", EGSR 2007, equation 21, in basic radiance L / n^2, so that factors
///   n^2 cancel on every path that begins and ends outside.
/// Both transmissions mask separably, and are tinted by the base colour. The half vector is drawn from the
/// visible normals, then reflection or transmission by their Fresnel-weighted luminances.
class SpecularLobe {
 public:
  SpecularLobe(const MaterialSample& material, const Fresnel& fresnel, vec3 wo, const Interface& interface);

  LobeValue evaluate(vec3 wi) const;
  /// `choice` decides between reflection and transmission.
  LobeSample sample(float choice, vec2 random) const;

  /// Directional albedo by the tables that the pixel multiplies back (directional_albedo.h); exact for
  /// isotropic reflection, an estimate for the rest.
  Rgb albedo() const { return reflectedAlbedo_ + transmittedAlbedo_; }
  bool isPresent() const { return maxComponent(albedo()) > 0.0f; }
  bool transmits() const { return maxComponent(tint_) > 0.0f; }
  vec2 alpha() const { return alpha_; }

 private:
  LobeValue reflect(vec3 wi) const;
  LobeValue transmitThin(vec3 wi) const;
  LobeValue refract(vec3 wi) const;
  float reflectProbability(float vDotH) const;

  const Fresnel& fresnel_;
  vec3 wo_;
  vec2 alpha_;
  float ior_;         ///< 0: thin wall
  Rgb tint_;          ///< of what is transmitted
  Rgb compensation_;  ///< of reflection, for multiple scattering
  Rgb reflectedAlbedo_, transmittedAlbedo_;
};

}  // namespace boxlight
