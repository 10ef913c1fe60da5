// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "common/image/image.h"
#include "common/light/lobe_boxes.h"

// What the tests of split lobes show: surfaces, what hides their light, and the light.

namespace boxlight {

constexpr uint32_t kEdge = 8;  ///< texels each way of the square; maps differ from texel to texel

VisibilityMap openMap();
/// Hidden by round things, others for every record.
VisibilityMap spottedMap(uint32_t record);

/// A soft sky, brighter to one side, and a sun.
Image skyEnvironment();

struct Finish {
  asset::Material material;
  asset::MaterialExtension extension;
  vec2 direction{1, 0};  ///< of the anisotropy in its texture
};

Finish metal(float roughness, float anisotropy = 0, float rotation = 0);
Finish brushed();  ///< the direction of the anisotropy comes from a texture
Finish varnish(float roughness);
Finish coated(float roughness);  ///< two lobes of the pixel's own, one over the other
Finish velvet();                 ///< beside the pixel's lobe there is one that kernels hold whole
Finish frosted();
Finish filmedMetal(float roughness);    ///< whose film is nearly black in red where it grazes
Finish filmedVarnish(float roughness);  ///< with a part of the film only

/// On a plane whose normal is +Y and whose bitangent is +Z.
GgxLobe lobeOf(const Finish& finish, vec3 view);
GgxLobe coatOf(const Finish& finish, vec3 view);

}  // namespace boxlight
