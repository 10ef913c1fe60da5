// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/base/math.h"

namespace boxlight {

/// What a pixel multiplies the demodulated kernels with, tabled over perceptual roughness and n.v. Single
/// scattering, as in glTF:
///   specular directional albedo = F0 * A + F90 * B,
///     A = int D V (1 - (1 - v.h)^5) n.l dl,   B = int D V (1 - v.h)^5 n.l dl   (ggx.h);
///   mean diffuse Fresnel factor k_d = 1 - specular * (F0max + (1 - F0max) * S),
///     S = (1 / pi) int (1 - v.h)^5 n.l dl;
/// The table is bilinear in the square roots of roughness and of n.v, where grazing angles and smooth
/// surfaces need their nodes; both ends of [0,1] are nodes. It is within 2e-3 of the integrals for alpha from
/// 1e-3 and n.v from .02.
struct AlbedoTable {
  static constexpr uint32_t kSize = 64;  ///< nodes along each axis: node i is (i / 63)^2
  std::vector<vec2> specularNodes;       ///< (A, B), [nDotV][roughness]
  std::vector<float> fresnelNodes;       ///< S, [nDotV]

  /// (A, B). Arguments are clamped to [0,1].
  vec2 specular(float roughness, float nDotV) const;
  /// S.
  float diffuseFresnel(float nDotV) const;
};

/// The table, computed by deterministic quadrature at the first call.
const AlbedoTable& albedoTable();

}  // namespace boxlight
