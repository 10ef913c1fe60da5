// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bake/scene/scene.h"

// Meshes without UVs that a charter can trip over. Units are metres.

namespace boxlight::test {

/// Adds triangles of one material; triangles without area are left out, as the loader does. Without normals,
/// every triangle gets vertices of its own with its face normal.
void addMesh(Scene& scene, const std::vector<vec3>& positions, const std::vector<uvec3>& triangles,
             const std::vector<vec3>& normals = {}, uint32_t material = 0);

/// An axis-aligned box of hard edges.
void addBox(Scene& scene, vec3 low, vec3 high);

/// The surface over (columns x rows) cells of the unit square, smooth, counter-clockwise seen along
/// cross(du, dv) reversed. Where it closes, its first and last vertices coincide.
void addSurface(Scene& scene, uvec2 cells, const std::function<vec3(vec2)>& position);

void addTorus(Scene& scene, vec3 centre, float radius, float tube, uint32_t segments);
void addMoebiusStrip(Scene& scene, uint32_t segments);
/// `turns` turns of a spiral ramp: flat enough for one chart, above itself.
void addSpiral(Scene& scene, uint32_t turns, uint32_t segmentsPerTurn);
/// Sheets that all meet in the edge from (0,0,0) to (0,1,0).
void addFan(Scene& scene, uint32_t sheets);
/// Squares at random places, turned at random, of the given side.
void addLeaves(Scene& scene, uint32_t count, float side);

/// Moves every vertex to scale * position + offset in floats, and drops the triangles that lose their area.
void place(Scene& scene, float scale, vec3 offset);

}  // namespace boxlight::test
