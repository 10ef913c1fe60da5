// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/mesh.h"

#include <cmath>
#include <utility>

namespace boxlight {
namespace {

// Embree leaves out what lies beyond about 1.8e18, and squares of larger floats overflow.
constexpr double kMaxCoordinate = 1e18;
// A triangle lower than this part of its longest edge is a line in float precision.
constexpr double kMinHeight = 1e-9;

// False if a coordinate is out of range.
bool transformVertices(Mesh& mesh, const glm::dmat4& toWorld) {
  const glm::dmat3 linear(toWorld);
  const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  // Cofactors instead of the inverse transpose: the same direction, also where a scale is zero.
  const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                             glm::cross(linear[0], linear[1]));
  bool inRange = true;
  for (asset::Vertex& v : mesh.vertices) {
    const dvec3 position = linear * positionOf(v) + dvec3(toWorld[3]);
    for (int i = 0; i < 3; ++i) inRange &= std::abs(position[i]) <= kMaxCoordinate;
    store(v.position, position);
    store(v.normal, normalizeOrZero(cofactors * normalOf(v)) * side);
    store(v.tangent, normalizeOrZero(linear * tangentOf(v)));
    v.tangent[3] *= float(side);
  }
  if (side < 0.0) {
    for (uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  }
  return inRange;
}

bool hasArea(const Mesh& mesh, uvec3 triangle) {
  const dvec3 a = positionOf(mesh.vertices[triangle.x]), b = positionOf(mesh.vertices[triangle.y]),
              c = positionOf(mesh.vertices[triangle.z]);
  const double longest =
      std::max(glm::dot(b - a, b - a), std::max(glm::dot(c - b, c - b), glm::dot(a - c, a - c)));
  return glm::length(glm::cross(b - a, c - a)) > kMinHeight * longest;
}

// The mean of the adjacent faces where the sum vanishes too is meaningless: then any face will do.
size_t replaceZeroNormals(Mesh& mesh) {
  const auto isZero = [](const asset::Vertex& v) { return normalOf(v) == dvec3(0.0); };
  std::vector<dvec3> sums, faces;
  for (const uvec3& triangle : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      if (!isZero(mesh.vertices[triangle[c]])) continue;
      sums.resize(mesh.vertices.size(), dvec3(0.0));
      faces.resize(mesh.vertices.size(), dvec3(0.0));
      const dvec3 face = faceVector(mesh, triangle);
      sums[triangle[c]] += face;
      faces[triangle[c]] = face;
    }
  }
  size_t replaced = 0;
  for (size_t i = 0; i < sums.size(); ++i) {
    if (faces[i] == dvec3(0.0)) continue;
    const dvec3 mean = normalizeOrZero(sums[i]);
    store(mesh.vertices[i].normal, mean == dvec3(0.0) ? normalizeOrZero(faces[i]) : mean);
    ++replaced;
  }
  return replaced;
}

void completeTangents(Mesh& mesh) {
  for (asset::Vertex& v : mesh.vertices) {
    const dvec3 n = normalOf(v);
    const dvec3 inPlane = tangentOf(v) - n * glm::dot(n, tangentOf(v));
    if (glm::length(inPlane) > 1e-4) {
      store(v.tangent, normalizeOrZero(inPlane));
      continue;
    }
    vec3 tangent, bitangent;
    orthonormalBasis(vec3(n), tangent, bitangent);
    store(v.tangent, dvec3(tangent));
    v.tangent[3] = 1.0f;
  }
}

}  // namespace

dvec3 faceVector(const Mesh& mesh, uvec3 triangle) {
  const dvec3 a = positionOf(mesh.vertices[triangle.x]);
  return glm::cross(positionOf(mesh.vertices[triangle.y]) - a, positionOf(mesh.vertices[triangle.z]) - a);
}

std::vector<uint32_t> compactIndices(std::vector<uvec3>& triangles, size_t vertexCount) {
  std::vector<uint32_t> number(vertexCount, 0);
  for (const uvec3& triangle : triangles) {
    for (int c = 0; c < 3; ++c) number[triangle[c]] = 1;
  }
  std::vector<uint32_t> used;
  for (uint32_t i = 0; i < vertexCount; ++i) {
    if (number[i] == 0) continue;
    number[i] = uint32_t(used.size());
    used.push_back(i);
  }
  for (uvec3& triangle : triangles) {
    for (int c = 0; c < 3; ++c) triangle[c] = number[triangle[c]];
  }
  return used;
}

void computeFlatNormals(Mesh& mesh) {
  std::vector<asset::Vertex> vertices;
  vertices.reserve(mesh.triangles.size() * 3);
  for (uvec3& triangle : mesh.triangles) {
    const dvec3 normal = normalizeOrZero(faceVector(mesh, triangle));
    for (int c = 0; c < 3; ++c) {
      vertices.push_back(mesh.vertices[triangle[c]]);
      store(vertices.back().normal, normal);
      triangle[c] = uint32_t(vertices.size() - 1);
    }
  }
  mesh.vertices = std::move(vertices);
}

Placement placeMesh(Mesh& mesh, const glm::dmat4& toWorld) {
  Placement placement;
  if (!transformVertices(mesh, toWorld)) return {.outOfRange = true};
  placement.droppedTriangles =
      std::erase_if(mesh.triangles, [&](const uvec3& t) { return !hasArea(mesh, t); });
  if (placement.droppedTriangles > 0) {
    const std::vector<uint32_t> used = compactIndices(mesh.triangles, mesh.vertices.size());
    for (size_t i = 0; i < used.size(); ++i) mesh.vertices[i] = mesh.vertices[used[i]];
    mesh.vertices.resize(used.size());
  }
  placement.replacedNormals = replaceZeroNormals(mesh);
  completeTangents(mesh);
  return placement;
}

}  // namespace boxlight
