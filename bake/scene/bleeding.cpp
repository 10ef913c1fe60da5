// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/bleeding.h"

#include <array>
#include <numeric>
#include <unordered_map>

#include "bake/scene/texels.h"
#include "common/base/file.h"

namespace boxlight {
namespace {

/// Chart of every triangle: triangles hang together where they share a point of the surface and of the atlas.
std::vector<uint32_t> findCharts(const Scene& scene) {
  using Key = std::array<float, 5>;
  const auto hash = [](const Key& key) { return size_t(xxh64(std::as_bytes(std::span(key)))); };
  std::vector<uint32_t> parent(scene.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::unordered_map<Key, uint32_t, decltype(hash)> first(scene.vertices.size(), hash);
  for (uint32_t v = 0; v < scene.vertices.size(); ++v) {
    const asset::Vertex& at = scene.vertices[v];
    const Key key{at.position[0] + 0.0f, at.position[1] + 0.0f, at.position[2] + 0.0f, at.atlasUv[0] + 0.0f,
                  at.atlasUv[1] + 0.0f};
    parent[v] = first.try_emplace(key, v).first->second;
  }
  for (const asset::Triangle& triangle : scene.triangles)
    for (int k = 1; k < 3; ++k) parent[root(triangle.vertex[k])] = root(triangle.vertex[0]);
  std::vector<uint32_t> charts;
  for (const asset::Triangle& triangle : scene.triangles) charts.push_back(root(triangle.vertex[0]));
  return charts;
}

/// Of one texel's surface, what belongs to one chart.
struct Part {
  uint32_t chart;
  float area;
};

/// The parts of every texel of a map.
class TexelParts {
 public:
  TexelParts(const TexelMap& map, const std::vector<uint32_t>& charts) {
    for (const Texel& texel : map.texels) {
      first_.push_back(uint32_t(parts_.size()));
      float before = 0;
      for (const FootprintPiece& piece : map.footprint(texel)) {
        add(charts[piece.triangle], piece.area - before);
        before = piece.area;
      }
      area_.push_back(before);
    }
    first_.push_back(uint32_t(parts_.size()));
  }

  std::span<const Part> of(uint32_t texel) const {
    return std::span(parts_).subspan(first_[texel], first_[texel + 1] - first_[texel]);
  }

  /// Of the texel's surface, what is not the chart's.
  double foreign(uint32_t texel, uint32_t chart) const {
    for (const Part& part : of(texel))
      if (part.chart == chart) return 1.0 - double(part.area) / area_[texel];
    return 1.0;
  }

 private:
  void add(uint32_t chart, float area) {
    for (size_t i = first_.back(); i < parts_.size(); ++i)
      if (parts_[i].chart == chart) {
        parts_[i].area += area;
        return;
      }
    parts_.push_back({chart, area});
  }

  std::vector<uint32_t> first_;
  std::vector<Part> parts_;
  std::vector<float> area_;
};

}  // namespace

double measureBleeding(const Scene& scene, uint32_t atlasSize) {
  // The filter's mean weights, over the points of a texel, of the texel itself and of the ones beside it.
  constexpr double kWeight[3] = {0.125, 0.75, 0.125};
  const TexelMap map = makeTexels(scene, atlasSize, atlasSize);
  const TexelParts parts(map, findCharts(scene));
  double foreign = 0, total = 0;
  for (uint32_t t = 0; t < map.texels.size(); ++t)
    for (const Part& part : parts.of(t)) {
      total += part.area;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const ivec2 at =
              glm::clamp(ivec2(map.texels[t].x + dx, map.texels[t].y + dy), 0, int(atlasSize) - 1);
          const uint32_t shown = map.nearest[size_t(at.y) * atlasSize + at.x];
          foreign += kWeight[dx + 1] * kWeight[dy + 1] * part.area * parts.foreign(shown, part.chart);
        }
    }
  return total > 0 ? foreign / total : 0.0;
}

}  // namespace boxlight
