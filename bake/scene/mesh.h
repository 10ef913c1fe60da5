// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "bake/scene/scene.h"

namespace boxlight {

/// Triangles with one material, on their way from a file into the scene.
struct Mesh {
  std::vector<asset::Vertex> vertices;  ///< normals and tangents are unit, or zero where nothing is known
  std::vector<uvec3> triangles;         ///< counter-clockwise from the front
  bool hasTexcoord[2] = {false, false};
  bool hasTangents = false;
};

inline dvec3 positionOf(const asset::Vertex& v) { return {v.position[0], v.position[1], v.position[2]}; }
inline dvec3 normalOf(const asset::Vertex& v) { return {v.normal[0], v.normal[1], v.normal[2]}; }
inline dvec3 tangentOf(const asset::Vertex& v) { return {v.tangent[0], v.tangent[1], v.tangent[2]}; }
/// Writes the three components of a position, a normal or a tangent.
inline void store(float* target, dvec3 v) {
  for (int i = 0; i < 3; ++i) target[i] = float(v[i]);
}

inline dvec3 normalizeOrZero(dvec3 v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : dvec3(0.0);
}

/// Twice the area times the unit normal of the front.
dvec3 faceVector(const Mesh& mesh, uvec3 triangle);

/// Renumbers the vertices of `triangles` so that only those in use remain, in their old order; returns their
/// old numbers.
std::vector<uint32_t> compactIndices(std::vector<uvec3>& triangles, size_t vertexCount);

/// Gives each triangle vertices of its own with its face normal (zero if it has no area).
void computeFlatNormals(Mesh& mesh);

/// What placeMesh had to mend.
struct Placement {
  size_t droppedTriangles = 0;  ///< without area
  size_t replacedNormals = 0;   ///< of zero length, now that of the adjacent faces
  bool outOfRange = false;      ///< a coordinate beyond +-1e18 m; the mesh is then unusable
};

/// Takes the mesh to world space. A transform that mirrors turns the winding and the tangents' sign.
/// Afterwards all normals are unit, all tangents unit and orthogonal to them, and no triangle has zero area.
Placement placeMesh(Mesh& mesh, const glm::dmat4& toWorld);

}  // namespace boxlight
