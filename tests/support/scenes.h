// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/scene.h"

namespace boxlight::test {

/// White Lambert (specular 0), not metallic.
asset::Material lambert(Rgb albedo = Rgb(1.0f));
/// White metal.
asset::Material metal(float roughness, Rgb colour = Rgb(1.0f));

/// A scene of one material with bounds set; add the geometry, then finish().
Scene makeScene(const asset::Material& material);
void finish(Scene& scene);

/// The parallelogram corner, corner + u, corner + u + v, corner + v; front side along cross(u, v). Its UVs
/// fill [uvMin, uvMax].
void addQuad(Scene& scene, vec3 corner, vec3 u, vec3 v, vec2 uvMin = vec2(0), vec2 uvMax = vec2(1),
             uint32_t material = 0);

/// Latitude-longitude sphere with smooth normals and UVs of the same layout.
void addSphere(Scene& scene, vec3 centre, float radius, uint32_t segments, bool inward = false);

}  // namespace boxlight::test
