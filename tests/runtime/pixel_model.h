// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "common/base/math.h"

namespace boxlight {

/// docs/theory.md, section 7, written down once more, in double precision and for values without textures.
struct PixelFactors {
  dvec3 diffuse{0.0}, transmitted{0.0}, glossy{0.0}, emission{0.0};
  dvec3 base{0.0}, coat{0.0};  ///< parts of `glossy`: what microfacets reflect
  glm::dvec2 albedo{0.0};      ///< A and B of the base
  dvec3 reflected{0.0};        ///< E_R without multiple scattering
};

/// F of the base by v.h, under a film or without.
Rgb baseFresnel(const asset::Material& material, const asset::MaterialExtension& extension, float vDotH);

/// `nDotV`, `coatNDotV`: of the shading normal and of the coat's normal, on the seen side.
PixelFactors pixelFactors(const asset::Material& material, const asset::MaterialExtension& extension,
                          double nDotV, double coatNDotV);

}  // namespace boxlight
