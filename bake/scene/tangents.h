// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/mesh.h"

namespace boxlight {

/// Sets the tangents of a mesh from its positions, unit normals and texture coordinates uv[set], in the
/// manner of MikkTSpace (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008): projected into the
/// plane of each corner's normal, weighted by the corner's angle, and summed over vertices that agree in
/// position, normal and uv. A vertex between triangles of opposite uv orientation is split. The w of a
/// tangent makes w * cross(normal, tangent) point up in the image, against v, as glTF's normal textures
/// demand. Tangents are zero where all triangles are degenerate in uv.
void computeTangents(Mesh& mesh, uint32_t set);

}  // namespace boxlight
