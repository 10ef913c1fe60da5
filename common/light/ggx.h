// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

// The microfacet terms of glTF 2.0, appendix B: GGX distribution (Walter et al., EGSR 2007),
// height-correlated Smith shadowing (Heitz, "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014)
// and Schlick's Fresnel weight. Everything is in the local frame whose z is the shading normal; directions
// are unit vectors that point away from the surface.

namespace boxlight::ggx {

inline constexpr float kMinAlpha =
    1e-4f;  ///< smoother than this a float half vector no longer resolves the lobe

/// alpha = roughness^2, at least kMinAlpha.
inline float alphaOf(float roughness) { return std::max(roughness * roughness, kMinAlpha); }

/// D(h), per steradian; 0 below the surface. From h's tangential part, so that it does not cancel at small
/// alpha.
float distribution(vec3 half, float alpha);

/// Smith's Lambda of a direction with cosine `cosine` > 0 to the normal.
float lambda(float cosine, float alpha);

/// G1(v) = 1 / (1 + Lambda(v)).
float masking(float cosine, float alpha);

/// V = G2(l, v) / (4 (n.l)(n.v)), height-correlated; both cosines > 0.
float visibility(float nDotL, float nDotV, float alpha);

/// (1 - v.h)^5: F = F0 + (F90 - F0) * this.
float schlickWeight(float vDotH);

// The anisotropic lobe: alpha along x and y. Heitz 2014, section 5.3; with equal components, the functions
// above.
float distribution(vec3 half, vec2 alpha);
float lambda(vec3 direction, vec2 alpha);
float masking(vec3 direction, vec2 alpha);
float visibility(vec3 light, vec3 view, vec2 alpha);

/// A half vector distributed as the normals visible from `view` (view.z >= 0), from `random` in [0,1)^2.
/// Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023.
vec3 sampleVisibleNormal(vec3 view, vec2 alpha, vec2 random);
inline vec3 sampleVisibleNormal(vec3 view, float alpha, vec2 random) {
  return sampleVisibleNormal(view, vec2(alpha), random);
}

/// Density of sampleVisibleNormal per steradian of half vector: G1(v) max(0, v.h) D(h) / n.v. The density of
/// the reflected direction is this / (4 v.h). Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT
/// 7(4), 2018.
float visibleNormalDensity(vec3 view, vec3 half, vec2 alpha);
inline float visibleNormalDensity(vec3 view, vec3 half, float alpha) {
  return visibleNormalDensity(view, half, vec2(alpha));
}

}  // namespace boxlight::ggx
