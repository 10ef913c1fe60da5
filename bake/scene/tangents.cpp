// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/tangents.h"

#include <array>
#include <cmath>
#include <span>
#include <unordered_map>

#include "common/base/file.h"

namespace boxlight {
namespace {

using asset::kNone;

// Vertices that share tangents: group[v] is the first vertex with the position, normal and uv of v.
std::vector<uint32_t> weld(const std::vector<asset::Vertex>& vertices, uint32_t set) {
  using Key = std::array<float, 8>;
  const auto keyOf = [set](const asset::Vertex& v) {
    Key key = {v.position[0], v.position[1], v.position[2], v.normal[0],
               v.normal[1],   v.normal[2],   v.uv[set][0],  v.uv[set][1]};
    for (float& f : key) f += 0.0f;  // -0 + 0 is +0: equal keys have equal bytes
    return key;
  };
  const auto hash = [](const Key& key) { return size_t(xxh64(std::as_bytes(std::span(key)))); };
  std::unordered_map<Key, uint32_t, decltype(hash)> first(vertices.size(), hash);
  std::vector<uint32_t> group(vertices.size());
  for (uint32_t v = 0; v < vertices.size(); ++v)
    group[v] = first.try_emplace(keyOf(vertices[v]), v).first->second;
  return group;
}

// How a triangle shows its texture to someone in front of it.
enum Orientation : uint8_t { kReadable = 0, kMirrored = 1, kDegenerate = 2 };

struct Chart {
  Orientation orientation;
  dvec3 direction;  // in which u grows, unit
};

Chart chartOf(const Mesh& mesh, uvec3 triangle, uint32_t set) {
  const asset::Vertex &a = mesh.vertices[triangle.x], &b = mesh.vertices[triangle.y],
                      &c = mesh.vertices[triangle.z];
  const dvec3 edge1 = positionOf(b) - positionOf(a), edge2 = positionOf(c) - positionOf(a);
  const double u1 = double(b.uv[set][0]) - a.uv[set][0], v1 = double(b.uv[set][1]) - a.uv[set][1];
  const double u2 = double(c.uv[set][0]) - a.uv[set][0], v2 = double(c.uv[set][1]) - a.uv[set][1];
  const double area = u1 * v2 - v1 * u2;
  if (area == 0.0) return {kDegenerate, dvec3(0.0)};
  const dvec3 direction = normalizeOrZero((edge1 * v2 - edge2 * v1) * (area > 0.0 ? 1.0 : -1.0));
  // v grows downwards in the image: a counter-clockwise triangle that is not mirrored runs clockwise in (u,
  // v).
  return {area < 0.0 ? kReadable : kMirrored, direction};
}

// What a corner adds to the sum of its vertex.
dvec3 cornerTangent(const Mesh& mesh, uvec3 triangle, int corner, dvec3 direction) {
  const asset::Vertex& v = mesh.vertices[triangle[corner]];
  const dvec3 n = normalOf(v), p = positionOf(v);
  const auto inPlane = [n](dvec3 d) { return normalizeOrZero(d - n * glm::dot(n, d)); };
  const dvec3 next = inPlane(positionOf(mesh.vertices[triangle[(corner + 1) % 3]]) - p);
  const dvec3 previous = inPlane(positionOf(mesh.vertices[triangle[(corner + 2) % 3]]) - p);
  return inPlane(direction) * std::acos(std::clamp(glm::dot(next, previous), -1.0, 1.0));
}

using Sums = std::vector<std::array<dvec3, 2>>;  // per group of vertices and orientation

Sums sumTangents(const Mesh& mesh, uint32_t set, const std::vector<uint32_t>& group,
                 std::vector<Orientation>& orientations) {
  Sums sums(mesh.vertices.size(), {dvec3(0.0), dvec3(0.0)});
  for (const uvec3& triangle : mesh.triangles) {
    const Chart chart = chartOf(mesh, triangle, set);
    orientations.push_back(chart.orientation);
    if (chart.orientation == kDegenerate) continue;
    for (int c = 0; c < 3; ++c) {
      sums[group[triangle[c]]][chart.orientation] += cornerTangent(mesh, triangle, c, chart.direction);
    }
  }
  return sums;
}

}  // namespace

void computeTangents(Mesh& mesh, uint32_t set) {
  const std::vector<uint32_t> group = weld(mesh.vertices, set);
  std::vector<Orientation> orientations;
  const Sums sums = sumTangents(mesh, set, group, orientations);

  // copies[v][o] stands for v with orientation o; the first orientation that comes keeps v itself.
  std::vector<std::array<uint32_t, 2>> copies(mesh.vertices.size(), {kNone, kNone});
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Orientation o = orientations[t];
    if (o == kDegenerate) continue;
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = mesh.triangles[t][c];
      uint32_t& copy = copies[v][o];
      if (copy == kNone) {
        copy = v;
        if (copies[v][1 - o] != kNone) {
          copy = uint32_t(mesh.vertices.size());
          mesh.vertices.push_back(asset::Vertex(mesh.vertices[v]));
        }
        store(mesh.vertices[copy].tangent, normalizeOrZero(sums[group[v]][o]));
        mesh.vertices[copy].tangent[3] = o == kReadable ? 1.0f : -1.0f;
      }
      mesh.triangles[t][c] = copy;
    }
  }
  mesh.hasTangents = true;
}

}  // namespace boxlight
