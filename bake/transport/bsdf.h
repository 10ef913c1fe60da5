// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "bake/transport/specular_lobe.h"

namespace boxlight {

/// Parts of a BSDF, as bits.
enum Lobes : uint32_t {
  kDiffuse = 1,          ///< Lambert
  kDiffuseTransmit = 2,  ///< Lambert, to the other side
  kSpecular = 4,         ///< reflection and transmission by microfacets
  kSheen = 8,
  kCoat = 16,
  kViewDependent = kSpecular | kSheen | kCoat,  ///< what a kernel has to store for each view
  kMirrored = kSpecular | kCoat,                ///< what microfacets reflect, if the direction is above
  kAllLobes = 31,
};

/// glTF 2.0 metallic-roughness with the ratified Khronos extensions (docs/theory.md, section 3), at one
/// point, as seen from wo: the local frame's z is the shading normal, its x the anisotropy's direction, all
/// directions point away from the surface, wo.z > 0; wi.z < 0 is the other side.
///   f = w_c coat + (1 - w_c) (sheen + a_s base)
///   base = mix(fresnel_mix(mix(mix(Lambert, Lambert transmission, d), specular transmission, t), GGX),
///   conductor, metallic)
/// The weights of coat and sheen depend on wo alone, so a pixel can multiply them back exactly.
class Bsdf {
 public:
  Bsdf(const MaterialSample& material, vec3 wo, const Interface& interface = {}, vec3 coatNormal = {0, 0, 1});
  Bsdf(const Bsdf&) = delete;

  /// The sum over `lobes` of f |cos wi|, and the density of sample() with the same lobes.
  LobeValue evaluate(vec3 wi, uint32_t lobes = kAllLobes) const;
  /// A direction, or 0; evaluate may be zero there. `choice` picks the lobe.
  LobeSample sample(float choice, vec2 random, uint32_t lobes = kAllLobes) const;

  /// Directional albedo of the view-dependent lobes as the pixel multiplies it back.
  Rgb viewDependentAlbedo() const;
  /// Radiance that the surface emits towards wo.
  Rgb emission() const { return emission_; }

  bool has(uint32_t lobes) const;
  /// Number of view-dependent lobes whose directions differ: reflection, transmission, sheen, coat.
  uint32_t viewDependentCount() const;
  /// Those of them that are not reflected by microfacets: transmission, sheen.
  uint32_t unmirroredCount() const;
  Rgb f0() const { return fresnel_.f0(); }
  bool isFilmed() const { return fresnel_.isFilmed(); }
  vec2 alpha() const { return specular_.alpha(); }
  /// The smallest alpha of those that microfacets reflect, along either axis; 1 if there is none.
  float sharpestAlpha() const;

 private:
  static constexpr size_t kCount = 5;
  LobeValue evaluateLobe(uint32_t index, vec3 wi) const;
  LobeValue lambert(vec3 wi, float side) const;
  LobeValue sheen(vec3 wi) const;
  LobeValue coat(vec3 wi) const;
  float coatShadowing(float nDotL, float nDotV) const;
  LobeSample sampleLobe(uint32_t index, float choice, vec2 random) const;
  void chooseProbabilities();

  Fresnel fresnel_;
  SpecularLobe specular_;
  vec3 wo_;
  vec3 coatNormal_, coatTangent_, coatBitangent_;
  float coatAlpha_ = 1, coatAlbedo_ = 0, sheenAlpha_ = 1, sheenAlbedo_ = 0;
  Rgb emission_{0.0f};
  std::array<Rgb, kCount> weight_{};         ///< of each lobe, by the bit's number
  std::array<float, kCount> probability_{};  ///< not normalised
};

}  // namespace boxlight
