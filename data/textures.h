// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "data/model.h"

namespace boxlight::data {

/// Squares of `square` texels, terracotta and pale blue, with a brightness gradient that shows the
/// orientation.
Texture checkerTexture(uint32_t size, uint32_t square);
/// glTF's metallic-roughness image: roughness (G) from .1 at the left to .9 at the right, metallic (B) 1.
Texture roughnessTexture(uint32_t size);
/// A leaf with holes: alpha 255 inside, 0 outside, white with darker veins.
Texture leafTexture(uint32_t size);
/// A tangent-space normal map of `count` round bumps across and down.
Texture bumpTexture(uint32_t size, uvec2 count);

}  // namespace boxlight::data
