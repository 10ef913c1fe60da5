// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset_reader.h"

namespace boxlight::gpu {

/// The size of the light's table that an asset asks for under an environment of `image` pixels: a power of
/// two from kLeastLightSize to kMostLightSize whose texels are half as wide and high, at most, as all boxes
/// but those with a twentieth of the energy; no more than half as fine as the image
/// (docs/decisions/007-table-sizes.md). Of kernels a sample of pages is read, of split lobes the core box.
/// Errors: those of AssetReader::page.
uvec2 chooseLightSize(const asset::AssetReader& reader, uvec2 image);

inline constexpr uvec2 kLeastLightSize{512, 256}, kMostLightSize{2048, 1024};

}  // namespace boxlight::gpu
