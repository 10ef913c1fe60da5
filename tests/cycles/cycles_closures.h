// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/transport/specular_lobe.h"

// Closures of Cycles 3.4 that no glTF material is, with the members of Bsdf (bake/transport/bsdf.h) that
// ReferenceIntegrator uses. With them transport can be compared without a difference of models
// (docs/theory.md, section 9). Their GGX masks separably: G1(i) G1(o).

namespace boxlight::cycles {

/// The Glossy and Anisotropic BSDF: GGX reflection of one colour at all angles. Other than metals are
/// Lambert, as the Diffuse BSDF.
class Metal {
 public:
  Metal(const MaterialSample& material, vec3 wo, const Interface& interface, vec3 coatNormal);

  Rgb emission() const { return Rgb(0.0f); }
  LobeValue evaluate(vec3 wi) const;
  LobeSample sample(float choice, vec2 random) const;

 private:
  vec3 wo_;
  Rgb colour_;
  vec2 alpha_;
  bool lambert_;
};

/// The Glass BSDF: reflection and refraction weighted by the exact Fresnel term of a dielectric at the
/// *shading normal*, not at the microfacets; total reflection at a microfacet absorbs. Surfaces without
/// transmission are Lambert.
class Glass {
 public:
  Glass(const MaterialSample& material, vec3 wo, const Interface& interface, vec3 coatNormal);

  Rgb emission() const { return Rgb(0.0f); }
  LobeValue evaluate(vec3 wi) const;
  LobeSample sample(float choice, vec2 random) const;

 private:
  vec3 wo_;
  Rgb colour_;
  vec2 alpha_;
  float ior_;  ///< far side over near side; 0: no glass
  float reflected_;
};

}  // namespace boxlight::cycles
