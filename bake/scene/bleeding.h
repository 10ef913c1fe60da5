// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/scene.h"

namespace boxlight {

/// How much of what a bilinear filter shows of the surface belongs to other charts of the atlas: the mean
/// over the surface's area, 0 to 1. Charts are what hangs together in the atlas; a texel shows the mean of
/// all that it covers. Of Vertex::atlasUv in an atlas of atlasSize x atlasSize texels.
double measureBleeding(const Scene& scene, uint32_t atlasSize);

}  // namespace boxlight
