// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bake/scene/chart_grow.h"

namespace boxlight {
namespace {

constexpr size_t kMostDirections = 96;  // of the convex hull that the rectangle is tried along

double cross2(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Welds the corners of the triangles: `corners` become numbers of the positions returned.
std::vector<uint32_t> weldCorners(const ChartMesh& mesh, Chart& chart) {
  std::vector<uint32_t> used;
  for (const uint32_t t : chart.triangles)
    used.insert(used.end(), mesh.position[t].begin(), mesh.position[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const uint32_t t : chart.triangles)
    for (uvec3& corner = chart.corners.emplace_back(); const int k : {0, 1, 2})
      corner[k] =
          uint32_t(std::lower_bound(used.begin(), used.end(), mesh.position[t][size_t(k)]) - used.begin());
  return used;
}

/// Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", 1979.
std::vector<dvec2> convexHull(std::vector<dvec2> points) {
  const auto less = [](dvec2 a, dvec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); };
  std::sort(points.begin(), points.end(), less);
  std::vector<dvec2> hull;
  const auto walk = [&hull](auto begin, auto end) {
    const size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross2(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other half starts with it
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  return hull;
}

struct Upright {
  dvec2 axis{1, 0}, low{0.0}, size{0.0};
  double area = std::numeric_limits<double>::infinity();
};

Upright along(const std::vector<dvec2>& hull, dvec2 axis) {
  dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const dvec2 p : hull) {
    const dvec2 q(glm::dot(axis, p), cross2(axis, p));
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  const dvec2 size = high - low;
  return {axis, low, size, size.x * size.y};
}

/// The tightest rectangle has a side along an edge of the convex hull (Freeman and Shapira 1975).
void turnUpright(Chart& chart) {
  const std::vector<dvec2> hull = convexHull(chart.points);
  Upright best = along(hull, {1, 0});
  const size_t step = hull.size() / kMostDirections + 1;
  for (size_t i = 0; i < hull.size(); i += step) {
    const dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = glm::length(edge);
    if (!(length > 0)) continue;
    const Upright candidate = along(hull, edge / length);
    if (candidate.area < best.area * (1 - 1e-9)) best = candidate;
  }
  if (best.size.x < best.size.y) best = along(hull, {best.axis.y, -best.axis.x});
  for (dvec2& p : chart.points)
    p = glm::clamp(dvec2(glm::dot(best.axis, p), cross2(best.axis, p)) - best.low, dvec2(0.0), best.size);
  chart.size = best.size;
}

/// Walks the chart breadth first from `starts`; returns the triangles in the order they are reached, and in
/// `source` the start that reached each.
std::vector<uint32_t> flood(const ChartMesh& mesh, const Chart& chart, std::vector<uint32_t> starts,
                            std::vector<uint32_t>& source) {
  std::vector<uint32_t> order = std::move(starts);
  for (const uint32_t start : order) source[start] = start;
  for (size_t i = 0; i < order.size(); ++i) {
    const uint32_t from = order[i];
    for (const uint32_t next : mesh.neighbour[chart.triangles[from]]) {
      const auto at = std::lower_bound(chart.triangles.begin(), chart.triangles.end(), next);
      if (at == chart.triangles.end() || *at != next) continue;
      const auto j = uint32_t(at - chart.triangles.begin());
      if (source[j] != asset::kNone) continue;
      source[j] = source[from];
      order.push_back(j);
    }
  }
  return order;
}

}  // namespace

Chart flatten(const ChartMesh& mesh, std::vector<uint32_t> triangles) {
  Chart chart;
  chart.triangles = std::move(triangles);
  const std::vector<uint32_t> used = weldCorners(mesh, chart);
  const vec3 axis(chartAxis(mesh, chart.triangles));
  vec3 u, v;
  orthonormalBasis(axis, u, v);
  const dvec3 origin = mesh.positions[used.front()];
  const double scale = mesh.scale[chart.triangles.front()];
  for (const uint32_t p : used) {
    const dvec3 d = mesh.positions[p] - origin;
    chart.points.push_back(scale * dvec2(glm::dot(d, dvec3(u)), glm::dot(d, dvec3(v))));
  }
  turnUpright(chart);
  return chart;
}

std::vector<ivec2> snap(const Chart& chart, double unitsPerMetre) {
  std::vector<ivec2> points;
  for (const dvec2 p : chart.points)
    points.emplace_back(std::llround(p.x * unitsPerMetre), std::llround(p.y * unitsPerMetre));
  if (chart.triangles.size() > 1 || findFlipped(chart, points).empty()) return points;
  const uvec3 c = chart.corners[0];
  const int width = std::max(kLeastExtent, int(std::llround(chart.size.x * unitsPerMetre)));
  points[c.x] = {0, 0};
  points[c.y] = {width, 0};
  points[c.z] = {0, kLeastExtent};
  return points;
}

std::pair<std::vector<uint32_t>, std::vector<uint32_t>> splitBetween(const ChartMesh& mesh,
                                                                     const Chart& chart, uint32_t a,
                                                                     uint32_t b) {
  std::vector<uint32_t> source(chart.triangles.size(), asset::kNone);
  flood(mesh, chart, {a, b}, source);
  std::pair<std::vector<uint32_t>, std::vector<uint32_t>> parts;
  for (size_t i = 0; i < source.size(); ++i)
    (source[i] == a ? parts.first : parts.second).push_back(chart.triangles[i]);
  return parts;
}

std::pair<std::vector<uint32_t>, std::vector<uint32_t>> halve(const ChartMesh& mesh, const Chart& chart) {
  std::vector<uint32_t> source(chart.triangles.size(), asset::kNone);
  const uint32_t end = flood(mesh, chart, {0}, source).back();
  std::fill(source.begin(), source.end(), asset::kNone);
  std::vector<uint32_t> order = flood(mesh, chart, {end}, source);
  for (uint32_t i = 0; i < source.size(); ++i)
    if (source[i] == asset::kNone) order.push_back(i);
  std::vector<uint32_t> first, second;
  for (size_t i = 0; i < order.size(); ++i)
    (2 * i < order.size() ? first : second).push_back(chart.triangles[order[i]]);
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  return {std::move(first), std::move(second)};
}

}  // namespace boxlight
