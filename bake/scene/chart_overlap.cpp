// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "bake/scene/chart.h"

namespace boxlight {
namespace {

using Point = glm::i64vec2;
using Pair = std::pair<uint32_t, uint32_t>;

constexpr size_t kLeafTriangles = 12;
constexpr size_t kBudgetPerTriangle = 64;  // visits of cells: a plain mesh takes about 40

int64_t cross2(Point a, Point b) { return a.x * b.y - a.y * b.x; }
int64_t side(Point a, Point b, Point p) { return cross2(b - a, p - a); }

struct Cell {
  Point low, high;
};

/// A tree over the plane, cut at each step where it sorts the triangles best, down to cells of few triangles
/// or of a fan around one vertex.
class OverlapSearch {
 public:
  OverlapSearch(const Chart& chart, const std::vector<ivec2>& points)
      : chart_(chart), points_(points), budget_(kBudgetPerTriangle * (chart.triangles.size() + 256)) {}

  std::optional<Pair> run() {
    std::vector<uint32_t> all(chart_.triangles.size());
    Cell cell{Point(points_[0]), Point(points_[0])};
    for (const ivec2 p : points_) cell = {glm::min(cell.low, Point(p)), glm::max(cell.high, Point(p))};
    for (uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    return search(all, cell);
  }

 private:
  Point corner(uint32_t t, int k) const { return Point(points_[chart_.corners[t][(k % 3)]]); }

  std::optional<Pair> search(const std::vector<uint32_t>& triangles, const Cell& cell) {
    if (triangles.size() <= kLeafTriangles) return comparePairs(triangles);
    if (const auto apex = commonVertex(triangles)) return compareFan(triangles, *apex);
    const Point extent = cell.high - cell.low;
    if (budget_ < triangles.size() || (extent.x <= 1 && extent.y <= 1)) return farApart(triangles);
    budget_ -= triangles.size();
    std::array<std::vector<uint32_t>, 2> best;
    Cell halves[2];
    bool found = false;
    for (int axis = 0; axis < 2; ++axis) {
      if (extent[axis] <= 1) continue;
      Cell lower = cell, upper = cell;
      lower.high[axis] = upper.low[axis] = cell.low[axis] + extent[axis] / 2;
      std::array<std::vector<uint32_t>, 2> parts = {inside(triangles, lower), inside(triangles, upper)};
      if (found && parts[0].size() + parts[1].size() >= best[0].size() + best[1].size()) continue;
      best = std::move(parts);
      halves[0] = lower, halves[1] = upper;
      found = true;
    }
    for (int half = 0; half < 2; ++half)
      if (const auto pair = search(best[size_t(half)], halves[half])) return pair;
    return std::nullopt;
  }

  /// Two triangles that a split can come between.
  static Pair farApart(const std::vector<uint32_t>& triangles) {
    return {triangles.front(), triangles.back()};
  }

  std::vector<uint32_t> inside(const std::vector<uint32_t>& triangles, const Cell& cell) const {
    std::vector<uint32_t> kept;
    for (const uint32_t t : triangles)
      if (touches(t, cell)) kept.push_back(t);
    return kept;
  }

  /// Do triangle and cell share area? Separating axes of both.
  bool touches(uint32_t t, const Cell& cell) const {
    const Point a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    const Point low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    if (low.x >= cell.high.x || low.y >= cell.high.y || high.x <= cell.low.x || high.y <= cell.low.y)
      return false;
    for (int k = 0; k < 3; ++k) {
      const Point p = corner(t, k), d = corner(t, k + 1) - p;
      // The cell's corner that lies farthest to the left of the edge.
      const Point q(d.y > 0 ? cell.low.x : cell.high.x, d.x > 0 ? cell.high.y : cell.low.y);
      if (cross2(d, q - p) <= 0) return false;
    }
    return true;
  }

  bool overlap(uint32_t s, uint32_t t) const { return !separates(s, t) && !separates(t, s); }

  /// Has an edge of s all of t on its outer side?
  bool separates(uint32_t s, uint32_t t) const {
    for (int k = 0; k < 3; ++k) {
      const Point a = corner(s, k), b = corner(s, k + 1);
      if (side(a, b, corner(t, 0)) <= 0 && side(a, b, corner(t, 1)) <= 0 && side(a, b, corner(t, 2)) <= 0)
        return true;
    }
    return false;
  }

  std::optional<Pair> comparePairs(const std::vector<uint32_t>& triangles) const {
    for (size_t i = 0; i < triangles.size(); ++i)
      for (size_t j = i + 1; j < triangles.size(); ++j)
        if (overlap(triangles[i], triangles[j])) return Pair{triangles[i], triangles[j]};
    return std::nullopt;
  }

  std::optional<uint32_t> commonVertex(const std::vector<uint32_t>& triangles) const {
    for (int k = 0; k < 3; ++k) {
      const uint32_t v = chart_.corners[triangles[0]][k];
      if (std::all_of(triangles.begin(), triangles.end(), [&](uint32_t t) {
            const uvec3 c = chart_.corners[t];
            return c.x == v || c.y == v || c.z == v;
          }))
        return v;
    }
    return std::nullopt;
  }

  struct Wedge {
    Point from, to;
    uint32_t triangle;
  };

  /// Triangles around one vertex overlap if and only if their wedges do: each against the next one around.
  std::optional<Pair> compareFan(const std::vector<uint32_t>& triangles, uint32_t apex) const {
    std::vector<Wedge> wedges;
    for (const uint32_t t : triangles) {
      const uvec3 c = chart_.corners[t];
      const int k = c.x == apex ? 0 : c.y == apex ? 1 : 2;
      wedges.push_back({corner(t, k + 1) - corner(t, k), corner(t, k + 2) - corner(t, k), t});
    }
    const auto lower = [](Point d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
    std::sort(wedges.begin(), wedges.end(), [&](const Wedge& a, const Wedge& b) {
      if (lower(a.from) != lower(b.from)) return lower(b.from);
      const int64_t turn = cross2(a.from, b.from);
      return turn != 0 ? turn > 0 : a.triangle < b.triangle;
    });
    for (size_t i = 0; i < wedges.size(); ++i) {
      const Wedge &a = wedges[i], &b = wedges[(i + 1) % wedges.size()];
      const int64_t turn = cross2(a.from, b.from);
      const bool sameWay = turn == 0 && a.from.x * b.from.x + a.from.y * b.from.y > 0;
      if (sameWay || (turn > 0 && cross2(b.from, a.to) > 0)) return Pair{a.triangle, b.triangle};
    }
    return std::nullopt;
  }

  const Chart& chart_;
  const std::vector<ivec2>& points_;
  size_t budget_;
};

}  // namespace

std::vector<uint32_t> findFlipped(const Chart& chart, const std::vector<ivec2>& points) {
  std::vector<uint32_t> flipped;
  for (uint32_t t = 0; t < chart.corners.size(); ++t) {
    const uvec3 c = chart.corners[t];
    if (side(points[c.x], points[c.y], points[c.z]) <= 0) flipped.push_back(t);
  }
  return flipped;
}

std::optional<Pair> findOverlap(const Chart& chart, const std::vector<ivec2>& points) {
  return OverlapSearch(chart, points).run();
}

}  // namespace boxlight
