// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/charting.h"

#include <cmath>
#include <iterator>
#include <optional>

#include "bake/scene/chart.h"
#include "bake/scene/chart_grow.h"
#include "bake/scene/chart_pack.h"

namespace boxlight {
namespace {

constexpr int kMostRounds = 8;    // of packing and mending; afterwards what is still wrong is taken apart
constexpr int kGuidedSplits = 6;  // of one chart between triangles that overlap; afterwards it is halved

/// Every third bit of 63 is one of x.
uint64_t spread(uint64_t x) {
  uint64_t result = 0;
  for (int bit = 0; bit < 21; ++bit) result |= (x >> bit & 1) << (3 * bit);
  return result;
}

using TriangleLists = std::vector<std::vector<uint32_t>>;

class Charter {
 public:
  Charter(Scene& scene, uint32_t atlasSize) : scene_(scene), mesh_(makeChartMesh(scene)), size_(atlasSize) {}

  Charting run(ProgressStyle style) {
    Progress progress("charting", (kGrowPasses + 1) * mesh_.size(), style);
    for (std::vector<uint32_t>& triangles : growCharts(mesh_, progress))
      charts_.push_back(flatten(mesh_, std::move(triangles)));
    for (int round = 0;; ++round) {
      packing_ = packCharts(charts_, kinships(), size_);
      if (!mend(round >= kMostRounds)) break;
    }
    progress.advance(mesh_.size());
    write();
    return {uint32_t(charts_.size()), packing_.shared, packing_.crumb, packing_.gutter,
            packing_.texelsPerMetre};
  }

 private:
  double unitsPerMetre() const { return packing_.texelsPerMetre * kAtlasUnits / size_; }

  std::vector<ChartKin> kinships() const {
    const dvec3 low = scene_.boundsMin, extent = dvec3(scene_.boundsMax) - low;
    std::vector<ChartKin> kin;
    for (const Chart& chart : charts_) {
      const uint32_t t = chart.triangles.front();
      const dvec3 n = mesh_.normal[t], a = glm::abs(n);
      const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
      uint64_t place = 0;
      for (int c = 0; c < 3; ++c) {
        const double at = extent[c] > 0 ? (mesh_.centroid[t][c] - low[c]) / extent[c] : 0;
        place |= spread(uint64_t(std::clamp(at, 0.0, 1.0) * ((1 << 21) - 1))) << c;
      }
      kin.push_back({uint64_t(mesh_.materials[t]) * 8 + uint64_t(2 * axis + (n[axis] < 0)), place});
    }
    return kin;
  }

  /// Splits charts that overlap themselves or show a triangle's back as they are snapped now. True if any
  /// did.
  bool mend(bool takeApart) {
    std::vector<Chart> sound;
    const size_t before = charts_.size();
    std::vector<std::pair<Chart, int>> open;  // with how often they have been split
    for (Chart& chart : charts_) {
      open.emplace_back(std::move(chart), 0);
      while (!open.empty()) {
        auto [next, splits] = std::move(open.back());
        open.pop_back();
        TriangleLists parts = splitIfFaulty(next, splits, takeApart);
        if (parts.empty()) sound.push_back(std::move(next));
        for (std::vector<uint32_t>& part : parts)
          open.emplace_back(flatten(mesh_, std::move(part)), splits + 1);
      }
    }
    charts_.swap(sound);
    return charts_.size() != before;
  }

  /// The parts of a chart that is not sound; none if it is.
  TriangleLists splitIfFaulty(const Chart& chart, int splits, bool takeApart) const {
    throwIfInterrupted("interrupted: no asset was written; run the same command again");
    if (chart.triangles.size() == 1) return {};
    const std::vector<ivec2> points = snap(chart, unitsPerMetre());
    const std::vector<uint32_t> flipped = findFlipped(chart, points);
    const auto overlap = flipped.empty() ? findOverlap(chart, points) : std::nullopt;
    if (flipped.empty() && !overlap) return {};
    if (takeApart) return takeOut(chart, chart.triangles);
    if (!overlap) return takeOut(chart, flippedTriangles(chart, flipped));
    auto [first, second] = splits < kGuidedSplits
                               ? splitBetween(mesh_, chart, overlap->first, overlap->second)
                               : halve(mesh_, chart);
    return {std::move(first), std::move(second)};
  }

  static std::vector<uint32_t> flippedTriangles(const Chart& chart, const std::vector<uint32_t>& flipped) {
    std::vector<uint32_t> triangles;
    for (const uint32_t i : flipped) triangles.push_back(chart.triangles[i]);
    return triangles;
  }

  /// Each of the triangles `alone`, and the rest.
  static TriangleLists takeOut(const Chart& chart, const std::vector<uint32_t>& alone) {
    TriangleLists parts;
    for (const uint32_t t : alone) parts.push_back({t});
    std::vector<uint32_t> rest;
    std::set_difference(chart.triangles.begin(), chart.triangles.end(), alone.begin(), alone.end(),
                        std::back_inserter(rest));
    if (!rest.empty()) parts.push_back(std::move(rest));
    return parts;
  }

  void write() {
    struct Claim {
      uint32_t chart = asset::kNone, vertex = 0;
    };
    std::vector<Claim> claims(scene_.vertices.size());
    for (uint32_t c = 0; c < charts_.size(); ++c) {
      const Chart& chart = charts_[c];
      const std::vector<ivec2> points = place(chart, packing_.origin[c]);
      for (size_t i = 0; i < chart.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
          uint32_t& vertex = scene_.triangles[chart.triangles[i]].vertex[k];
          Claim& claim = claims[vertex];
          if (claim.chart == asset::kNone) {
            claim = {c, vertex};
          } else if (claim.chart != c) {
            claim = {c, uint32_t(scene_.vertices.size())};
            scene_.vertices.push_back(asset::Vertex(scene_.vertices[vertex]));
          }
          vertex = claim.vertex;
          const ivec2 p = points[chart.corners[i][k]];
          for (int axis = 0; axis < 2; ++axis)
            scene_.vertices[vertex].atlasUv[axis] = float(p[axis] / kAtlasUnits);
        }
    }
  }

  std::vector<ivec2> place(const Chart& chart, dvec2 origin) const {
    std::vector<ivec2> points = snap(chart, unitsPerMetre());
    ivec2 high(0);
    for (const ivec2 p : points) high = glm::max(high, p);
    const ivec2 corner =
        glm::min(ivec2(glm::round(origin * (kAtlasUnits / size_))), ivec2(int(kAtlasUnits)) - high);
    for (ivec2& p : points) p += corner;
    return points;
  }

  Scene& scene_;
  const ChartMesh mesh_;
  const uint32_t size_;
  std::vector<Chart> charts_;
  Packing packing_;
};

}  // namespace

Charting chartScene(Scene& scene, uint32_t atlasSize, ProgressStyle progress) {
  return Charter(scene, atlasSize).run(progress);
}

}  // namespace boxlight
