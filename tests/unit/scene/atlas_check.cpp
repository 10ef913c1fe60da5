// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/scene/atlas_check.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace boxlight::test {
namespace {

using Point = std::array<int64_t, 2>;
using Corners = std::array<Point, 3>;

Corners cornersOf(const Scene& scene, uint32_t t) {
  Corners corners;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 2; ++c)
      corners[k][c] = int64_t(double(scene.vertices[scene.triangles[t].vertex[k]].atlasUv[c]) * 0x1p24);
  return corners;
}

int64_t side(const Point& a, const Point& b, const Point& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

bool separatedBy(const Corners& a, const Corners& b) {
  for (int k = 0; k < 3; ++k) {
    const Point &p = a[k], &q = a[(k + 1) % 3];
    if (side(p, q, b[0]) <= 0 && side(p, q, b[1]) <= 0 && side(p, q, b[2]) <= 0) return true;
  }
  return false;
}

int64_t lowest(const Corners& c, int axis) { return std::min({c[0][axis], c[1][axis], c[2][axis]}); }
int64_t highest(const Corners& c, int axis) { return std::max({c[0][axis], c[1][axis], c[2][axis]}); }

void worldCorners(const Scene& scene, uint32_t t, dvec3 (&p)[3]) {
  for (int k = 0; k < 3; ++k) {
    const float* q = scene.vertices[scene.triangles[t].vertex[k]].position;
    p[k] = {q[0], q[1], q[2]};
  }
}

double worldArea(const Scene& scene, uint32_t t) {
  dvec3 p[3];
  worldCorners(scene, t, p);
  return 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
}

/// The chart of every triangle, by union-find over points that agree in position and atlas.
std::vector<uint32_t> chartsOf(const Scene& scene) {
  std::vector<uint32_t> parent(scene.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&parent](uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::map<std::array<float, 5>, uint32_t> first;
  for (uint32_t t = 0; t < scene.triangles.size(); ++t)
    for (const uint32_t v : scene.triangles[t].vertex) {
      const asset::Vertex& x = scene.vertices[v];
      const uint32_t other =
          first.try_emplace({x.position[0], x.position[1], x.position[2], x.atlasUv[0], x.atlasUv[1]}, t)
              .first->second;
      parent[find(t)] = find(other);
    }
  for (uint32_t t = 0; t < parent.size(); ++t) parent[t] = find(t);
  return parent;
}

/// By the upright box in the atlas, as charts are laid out: long side along u. `limit` in atlas units.
std::vector<bool> crumbsOf(const Scene& scene, const std::vector<uint32_t>& charts, double limit) {
  std::vector<Point> low(charts.size(), {1 << 30, 1 << 30}), high(charts.size(), {-1, -1});
  for (uint32_t t = 0; t < charts.size(); ++t) {
    const Corners corners = cornersOf(scene, t);
    for (int axis = 0; axis < 2; ++axis) {
      low[charts[t]][axis] = std::min(low[charts[t]][axis], lowest(corners, axis));
      high[charts[t]][axis] = std::max(high[charts[t]][axis], highest(corners, axis));
    }
  }
  std::vector<bool> crumbs;
  for (uint32_t c = 0; c < charts.size(); ++c)
    crumbs.push_back(double(high[c][0] - low[c][0]) <= limit + 2 ||
                     double(high[c][1] - low[c][1]) <= limit / 8 + 2);
  return crumbs;
}

}  // namespace

std::vector<uint32_t> findOverlapInAtlas(const Scene& scene) {
  std::vector<Corners> corners;
  std::vector<uint32_t> order(scene.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const uint32_t t : order) {
    corners.push_back(cornersOf(scene, t));
    if (side(corners[t][0], corners[t][1], corners[t][2]) <= 0) return {t, t};
  }
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return lowest(corners[a], 0) < lowest(corners[b], 0); });
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size(); ++j) {
      const Corners &a = corners[order[i]], &b = corners[order[j]];
      if (lowest(b, 0) >= highest(a, 0)) break;
      if (lowest(b, 1) >= highest(a, 1) || lowest(a, 1) >= highest(b, 1)) continue;
      if (!separatedBy(a, b) && !separatedBy(b, a)) return {order[i], order[j]};
    }
  return {};
}

double footprintError(const Scene& scene, const TexelMap& map) {
  std::vector<double> share(scene.triangles.size(), 0);
  for (const Texel& texel : map.texels)
    for (const FootprintPiece& piece : map.footprint(texel)) {
      const dvec2 a = dvec2(piece.corner[1]) - dvec2(piece.corner[0]),
                  b = dvec2(piece.corner[2]) - dvec2(piece.corner[0]);
      share[piece.triangle] += std::abs(a.x * b.y - a.y * b.x);
    }
  double worst = 0;
  for (const double s : share) worst = std::max(worst, std::abs(s - 1));
  return worst;
}

Stretch measureStretch(const Scene& scene, uint32_t atlasSize) {
  const std::vector<float> scale = texelScaleOfTriangles(scene);
  Stretch result;
  double total = 0;
  for (uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const Corners corners = cornersOf(scene, t);
    dvec3 p[3];
    worldCorners(scene, t, p);
    const double area = worldArea(scene, t);
    total += area;
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, std::hypot(double(corners[(k + 1) % 3][0] - corners[k][0]),
                                             double(corners[(k + 1) % 3][1] - corners[k][1])));
    if (double(side(corners[0], corners[1], corners[2])) < 64 * longest) {
      result.leftOut += area;
      continue;
    }
    // In an orthonormal frame of the triangle, with x along its first edge.
    const dvec3 e = p[1] - p[0], f = p[2] - p[0];
    const double ex = glm::length(e), fx = glm::dot(f, e) / ex, fy = 2 * area / ex;
    const double toTexels = atlasSize / 0x1p24 / scale[t];
    dvec2 u(corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]);
    dvec2 v(corners[2][0] - corners[0][0], corners[2][1] - corners[0][1]);
    const dvec2 dx = u * toTexels / ex, dy = (v * toTexels - dx * fx) / fy;
    const double sum = glm::dot(dx, dx) + glm::dot(dy, dy), product = std::abs(dx.x * dy.y - dx.y * dy.x);
    const double root = std::sqrt(std::max(0.0, sum * sum / 4 - product * product));
    result.most = std::max(result.most, std::sqrt(sum / 2 + root));
    result.least = std::min(result.least, std::sqrt(std::max(0.0, sum / 2 - root)));
  }
  result.leftOut /= total;
  return result;
}

uint32_t countLeaks(const Scene& scene, const TexelMap& map, double crumb, uint32_t coarser) {
  constexpr uint32_t kCrumbs = ~0u;  // stands for all of them
  std::vector<uint32_t> charts = chartsOf(scene);
  const std::vector<bool> isCrumb = crumbsOf(scene, charts, crumb / map.width * 0x1p24);
  for (uint32_t t = 0; t < charts.size(); ++t)
    if (isCrumb[charts[t]]) charts[t] = kCrumbs;
  using Place = std::pair<int, int>;
  std::map<Place, std::set<uint32_t>> covered;
  for (const Texel& texel : map.texels)
    for (const FootprintPiece& piece : map.footprint(texel))
      covered[{int(texel.x / coarser), int(texel.y / coarser)}].insert(charts[piece.triangle]);
  uint32_t leaks = 0;
  for (const auto& [at, own] : covered) {
    leaks += own.size() != 1;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Place read{at.first + dx, at.second + dy};
        // Whoever covers it, or is as near to it as this chart: at most the square root of two away.
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x) {
            if (x * x + y * y > dx * dx + dy * dy) continue;
            const auto near = covered.find({read.first + x, read.second + y});
            leaks += near != covered.end() && near->second != own;
          }
      }
  }
  return leaks;
}

uint32_t countCharts(const Scene& scene) {
  const std::vector<uint32_t> charts = chartsOf(scene);
  return uint32_t(std::set<uint32_t>(charts.begin(), charts.end()).size());
}

}  // namespace boxlight::test
