// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "common/asset/asset.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// Has any kernel of the asset glossy boxes?
bool isGlossy(const asset::Asset& asset);
/// Has any record a Lambert kernel?
bool hasLambertKernels(const asset::Asset& asset);
/// Are any lobes split into what the pixel sees straight and what kernels hold?
bool hasSplitLobes(const asset::Asset& asset);

/// Are the light's moments asked for?
inline bool needsMoments(const asset::Asset& asset) {
  return hasLambertKernels(asset) || hasSplitLobes(asset);
}
/// Has any material alpha that is coverage?
bool isBlended(const asset::Asset& asset);
/// Does a normal map bend any material's base layer?
bool isNormalMapped(const asset::Asset& asset);
bool hasSheen(const asset::Asset& asset);
/// Does any record store what it sees of other surfaces by the directions that light comes from?
bool hasDirectionCells(const asset::Asset& asset);

/// What the shaders that look at surfaces are specialised to, by kConstant... of shaders/shared.h: whatever
/// an asset does not have is not compiled in.
using SurfaceConstants = std::array<uint32_t, kSurfaceConstants>;

/// `layers`: blended layers of a sample at most; 0 if nothing is blended. Whether there is a background is
/// for ResolvePass to say.
SurfaceConstants surfaceConstants(const asset::Asset& asset, uint32_t layers);

}  // namespace boxlight::gpu
