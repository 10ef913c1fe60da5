// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/chart_mesh.h"

#include <cmath>
#include <span>
#include <unordered_map>

#include "bake/scene/mesh.h"
#include "common/base/file.h"

namespace boxlight {
namespace {

constexpr double kFlatCosine = 0.8660254037844387;  // 30 degrees: beyond, an edge is hard
constexpr size_t kMostPaired = 64;  // triangles at one edge among which the flattest pairs are looked for

/// The welded number of every vertex.
std::vector<uint32_t> weld(const Scene& scene, std::vector<dvec3>& positions) {
  using Key = std::array<float, 3>;
  const auto hash = [](const Key& key) { return size_t(xxh64(std::as_bytes(std::span(key)))); };
  std::unordered_map<Key, uint32_t, decltype(hash)> first(scene.vertices.size(), hash);
  std::vector<uint32_t> welded(scene.vertices.size());
  for (size_t v = 0; v < scene.vertices.size(); ++v) {
    const float* p = scene.vertices[v].position;
    const auto [entry, isNew] =
        first.try_emplace({p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f}, uint32_t(positions.size()));
    if (isNew) positions.emplace_back(p[0], p[1], p[2]);
    welded[v] = entry->second;
  }
  return welded;
}

struct HalfEdge {
  uint32_t low, high;    // welded ends
  uint32_t first, last;  // vertices of the scene at the low and the high end
  uint32_t triangle;
  uint8_t k;
  bool forward;  // from low to high
};

class Pairing {
 public:
  Pairing(const Scene& scene, ChartMesh& mesh) : scene_(scene), mesh_(mesh) {}

  void run() {
    std::vector<HalfEdge> edges = collect();
    for (size_t begin = 0; begin < edges.size();) {
      size_t end = begin + 1;
      while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
        ++end;
      pair(std::span(edges).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  std::vector<HalfEdge> collect() const {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh_.size());
    for (uint32_t t = 0; t < mesh_.size(); ++t)
      for (uint8_t k = 0; k < 3; ++k) {
        const uint32_t a = mesh_.position[t][k], b = mesh_.position[t][(k + 1) % 3];
        const uint32_t va = scene_.triangles[t].vertex[k], vb = scene_.triangles[t].vertex[(k + 1) % 3];
        if (a < b) edges.push_back({a, b, va, vb, t, k, true});
        if (a > b) edges.push_back({b, a, vb, va, t, k, false});
      }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
      return std::tie(a.low, a.high, a.first, a.last, a.triangle, a.k) <
             std::tie(b.low, b.high, b.first, b.last, b.triangle, b.k);
    });
    return edges;
  }

  void pair(std::span<const HalfEdge> group) {
    if (group.size() == 2) {
      link(group[0], group[1]);
    } else if (group.size() > 2 && group.size() <= kMostPaired) {
      pairByVertices(group);
      pairFlattest(group);
    } else if (group.size() > kMostPaired) {
      pairByVertices(group);
    }
  }

  /// Doubled sheets keep apart: exactly two triangles with the same two vertices belong together.
  void pairByVertices(std::span<const HalfEdge> group) {
    const auto same = [](const HalfEdge& a, const HalfEdge& b) {
      return a.first == b.first && a.last == b.last;
    };
    for (size_t i = 0; i + 1 < group.size();) {
      size_t end = i + 1;
      while (end < group.size() && same(group[i], group[end])) ++end;
      if (end - i == 2) link(group[i], group[i + 1]);
      i = end;
    }
  }

  void pairFlattest(std::span<const HalfEdge> group) {
    while (true) {
      double flattest = -1;
      const HalfEdge *a = nullptr, *b = nullptr;
      for (size_t i = 0; i < group.size(); ++i)
        for (size_t j = i + 1; j < group.size(); ++j) {
          if (!mayCross(group[i], group[j])) continue;
          const double cosine = glm::dot(mesh_.normal[group[i].triangle], mesh_.normal[group[j].triangle]);
          if (cosine > flattest) flattest = cosine, a = &group[i], b = &group[j];
        }
      if (!a) return;
      link(*a, *b);
    }
  }

  bool isFree(const HalfEdge& e) const { return mesh_.neighbour[e.triangle][e.k] == asset::kNone; }

  bool mayCross(const HalfEdge& a, const HalfEdge& b) const {
    if (a.forward == b.forward || a.triangle == b.triangle || !isFree(a) || !isFree(b)) return false;
    if (mesh_.materials[a.triangle] != mesh_.materials[b.triangle] ||
        mesh_.scale[a.triangle] != mesh_.scale[b.triangle])
      return false;
    const auto agree = [&](uint32_t v, uint32_t w) {
      return glm::dot(normalOf(scene_.vertices[v]), normalOf(scene_.vertices[w])) >= kFlatCosine;
    };
    return glm::dot(mesh_.normal[a.triangle], mesh_.normal[b.triangle]) >= kFlatCosine ||
           (agree(a.first, b.first) && agree(a.last, b.last));
  }

  void link(const HalfEdge& a, const HalfEdge& b) {
    if (!mayCross(a, b)) return;
    mesh_.neighbour[a.triangle][a.k] = b.triangle;
    mesh_.neighbour[b.triangle][b.k] = a.triangle;
  }

  const Scene& scene_;
  ChartMesh& mesh_;
};

}  // namespace

ChartMesh makeChartMesh(const Scene& scene) {
  ChartMesh mesh;
  const std::vector<uint32_t> welded = weld(scene, mesh.positions);
  const size_t count = scene.triangles.size();
  mesh.neighbour.assign(count, {asset::kNone, asset::kNone, asset::kNone});
  mesh.scale = texelScaleOfTriangles(scene);
  for (const asset::Triangle& triangle : scene.triangles) {
    std::array<uint32_t, 3>& corner = mesh.position.emplace_back();
    dvec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = mesh.positions[corner[k] = welded[triangle.vertex[k]]];
    const dvec3 face = glm::cross(p[1] - p[0], p[2] - p[0]);
    mesh.area.push_back(0.5 * glm::length(face));
    mesh.normal.push_back(normalizeOrZero(face));
    mesh.centroid.push_back((p[0] + p[1] + p[2]) / 3.0);
    mesh.materials.push_back(triangle.material);
  }
  Pairing(scene, mesh).run();
  return mesh;
}

}  // namespace boxlight
