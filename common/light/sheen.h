// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/base/math.h"

// The sheen lobe of KHR_materials_sheen: Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF",
// SIGGRAPH 2017 physically based shading course. Local frame as in ggx.h.

namespace boxlight::sheen {

/// alpha = roughness^2, at least .001, where the lobe is a rim of a degree.
inline float alphaOf(float roughness) { return std::max(roughness * roughness, 1e-3f); }

/// D(h) (2 + 1/alpha) sin(theta_h)^(1/alpha) / (2 pi), per steradian.
float distribution(vec3 half, float alpha);

/// V = 1 / ((1 + Lambda(v) + Lambda(l)) 4 (n.l)(n.v)) with the paper's fitted Lambda; both cosines > 0.
float visibility(float nDotL, float nDotV, float alpha);

/// Directional albedo of a sheen of colour 1, int D V n.l dl, at most 1: tabled as albedo_nodes.h says,
/// computed at the first call.
const std::vector<float>& albedoNodes();
float albedo(float roughness, float nDotV);

}  // namespace boxlight::sheen
