// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/asset/asset.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// The textures of an asset as the shaders read them.
struct TextureSet {
  std::vector<TextureHeader> headers;  ///< one a texture
  std::vector<TextureLevel> levels;
  std::vector<uint32_t> texels;  ///< RGBA8 in the texture's own encoding
};

/// Adds a mip chain to every texture that is minified trilinearly. Each level halves the sides, rounded down,
/// and is the mean of the level before over exact areas, in linear space.
TextureSet makeTextureSet(const asset::Asset& asset);

}  // namespace boxlight::gpu
