// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/uv_set.h"

#include <fmt/format.h>

#include <cmath>

namespace boxlight {
namespace {

constexpr int kRaster = 2048;       // samples per side
constexpr double kRoundOff = 1e-3;  // overlap that exporters' rounding along shared edges explains
constexpr uint64_t kMinimumSamples =
    1024;  // with fewer covered, nothing is known about overlap: under .03 % of the square
constexpr float kInsideSlack = 1e-5f;  // of the unit square's border

using i64 = int64_t;
struct Point {
  i64 x, y;
};

constexpr i64 kSubSteps =
    1024;  // fixed point per sample: edge functions are exact, shared edges are counted once

Point toFixed(const float uv[2]) {
  return {std::llround(double(uv[0]) * kRaster * kSubSteps),
          std::llround(double(uv[1]) * kRaster * kSubSteps)};
}

i64 edge(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

/// Samples exactly on an edge belong to one of its two triangles: the one for which the edge points right, or
/// up if vertical.
i64 edgeBias(Point a, Point b) { return (b.y > a.y || (b.y == a.y && b.x < a.x)) ? 0 : -1; }

template <class Visit>
void rasterise(Point a, Point b, Point c, const Visit& visit) {
  if (edge(a, b, c) < 0) std::swap(b, c);
  auto first = [](i64 x) { return int(std::clamp<i64>((x - kSubSteps / 2) / kSubSteps, 0, kRaster - 1)); };
  const int x0 = first(std::min({a.x, b.x, c.x})), x1 = first(std::max({a.x, b.x, c.x}) + kSubSteps);
  const int y0 = first(std::min({a.y, b.y, c.y})), y1 = first(std::max({a.y, b.y, c.y}) + kSubSteps);
  const i64 biasA = edgeBias(b, c), biasB = edgeBias(c, a), biasC = edgeBias(a, b);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const Point p{x * kSubSteps + kSubSteps / 2, y * kSubSteps + kSubSteps / 2};
      if (edge(b, c, p) + biasA >= 0 && edge(c, a, p) + biasB >= 0 && edge(a, b, p) + biasC >= 0) visit(x, y);
    }
}

double surfaceArea(const Scene& scene, const asset::Triangle& triangle) {
  vec3 p[3];
  for (int k = 0; k < 3; ++k) {
    const float* q = scene.vertices[triangle.vertex[k]].position;
    p[k] = {q[0], q[1], q[2]};
  }
  return 0.5 * glm::length(glm::cross(dvec3(p[1]) - dvec3(p[0]), dvec3(p[2]) - dvec3(p[0])));
}

bool isInside(const float uv[2]) {
  return uv[0] >= -kInsideSlack && uv[0] <= 1 + kInsideSlack && uv[1] >= -kInsideSlack &&
         uv[1] <= 1 + kInsideSlack;
}

}  // namespace

std::string UvSetReport::fault() const {
  if (missing) return "is missing on some primitive";
  if (!inside) return "leaves [0,1]";
  if (overlap > kRoundOff) return fmt::format("overlaps itself on {:.1f} % of its area", 100 * overlap);
  if (samples < kMinimumSamples) return "covers less than .03 % of the unit square";
  if (collapsed > kRoundOff) return fmt::format("has no area for {:.1f} % of the surface", 100 * collapsed);
  return {};
}

UvSetReport inspectUvSet(const Scene& scene, uint32_t set) {
  UvSetReport report;
  report.missing = !scene.hasTexcoord[set];
  if (report.missing) return report;
  for (const asset::Vertex& vertex : scene.vertices) report.inside &= isInside(vertex.uv[set]);
  if (!report.inside) return report;
  std::vector<uint8_t> covered(size_t(kRaster) * kRaster, 0);
  double total = 0, collapsed = 0;
  uint64_t once = 0, again = 0;
  for (const asset::Triangle& triangle : scene.triangles) {
    Point p[3];
    for (int k = 0; k < 3; ++k) p[k] = toFixed(scene.vertices[triangle.vertex[k]].uv[set]);
    const double area = surfaceArea(scene, triangle);
    total += area;
    if (edge(p[0], p[1], p[2]) == 0) {
      collapsed += area;
      continue;
    }
    rasterise(p[0], p[1], p[2], [&](int x, int y) {
      uint8_t& count = covered[size_t(y) * kRaster + x];
      once += count == 0;
      again += count == 1;
      count = uint8_t(std::min(count + 1, 2));
    });
  }
  report.samples = once;
  report.overlap = once ? double(again) / double(once) : 0.0;
  report.collapsed = total > 0 ? collapsed / total : 1.0;
  return report;
}

}  // namespace boxlight
