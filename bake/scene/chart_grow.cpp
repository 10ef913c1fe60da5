// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/chart_grow.h"

#include <queue>
#include <tuple>

#include "bake/scene/chart_merge.h"
#include "bake/scene/normal_set.h"

namespace boxlight {
namespace {

constexpr double kNarrowCosine = 0.766;  // of a cone whose mean normal is good enough an axis
constexpr double kTurnCost = 2;          // of a step to a triangle that is turned away, in step lengths

struct Seed {
  uint32_t triangle;
  dvec3 axis;
};

/// Distance along the surface at which a chart reaches a triangle.
struct Reach {
  double distance;
  uint32_t triangle, chart;
  bool operator<(const Reach& other) const {  // a priority_queue hands out the largest: the nearest
    return std::tie(distance, triangle, chart) > std::tie(other.distance, other.triangle, other.chart);
  }
};

/// Seeds flood the mesh together, each inside a cone around its axis; the seeds are moved to the middle of
/// what they reached, and so on: Lloyd's iteration, as in Cohen-Steiner, Alliez and Desbrun, "Variational
/// Shape Approximation", SIGGRAPH 2004.
class Grower {
 public:
  Grower(const ChartMesh& mesh, Progress& progress)
      : mesh_(mesh), progress_(progress), chart_(mesh.size(), asset::kNone) {}

  std::vector<std::vector<uint32_t>> run() {
    seedRest();
    for (uint64_t pass = 1; pass < kGrowPasses; ++pass) {
      count_ = mergeCharts(mesh_, chart_, count_);
      moveSeeds();
      std::fill(chart_.begin(), chart_.end(), asset::kNone);
      flood(0);
      seedRest();
    }
    count_ = mergeCharts(mesh_, chart_, count_);
    expelOutliers();
    return lists();
  }

 private:
  void push(double distance, uint32_t triangle, uint32_t chart) {
    if (chart_[triangle] == asset::kNone) queue_.push({distance, triangle, chart});
  }

  /// Grows the charts of the seeds from `first` on over what has none.
  void flood(size_t first) {
    for (size_t c = first; c < seeds_.size(); ++c) push(0, seeds_[c].triangle, uint32_t(c));
    while (!queue_.empty()) {
      const Reach reach = queue_.top();
      queue_.pop();
      if (chart_[reach.triangle] != asset::kNone) continue;
      chart_[reach.triangle] = reach.chart;
      if (++reached_ % 4096 == 0)
        throwIfInterrupted("interrupted: no asset was written; run the same command again");
      progress_.advance();
      for (const uint32_t next : mesh_.neighbour[reach.triangle]) {
        if (next == asset::kNone || chart_[next] != asset::kNone) continue;
        const double cosine = glm::dot(mesh_.normal[next], seeds_[reach.chart].axis);
        if (cosine < kGrowCosine) continue;
        const double step = glm::distance(mesh_.centroid[next], mesh_.centroid[reach.triangle]);
        push(reach.distance + step * (1 + kTurnCost * (1 - cosine)), next, reach.chart);
      }
    }
  }

  /// New charts where no seed came, in the order of the triangles.
  void seedRest() {
    for (uint32_t t = 0; t < mesh_.size(); ++t) {
      if (chart_[t] != asset::kNone) continue;
      seeds_.push_back({t, mesh_.normal[t]});
      flood(seeds_.size() - 1);
    }
    count_ = uint32_t(seeds_.size());
  }

  /// To each chart its axis, and as seed the triangle nearest to its centroid.
  void moveSeeds() {
    std::vector<dvec3> centre(count_, dvec3(0.0));
    std::vector<double> area(count_, 0), nearest(count_, std::numeric_limits<double>::infinity());
    for (uint32_t t = 0; t < mesh_.size(); ++t) {
      centre[chart_[t]] += mesh_.area[t] * mesh_.centroid[t];
      area[chart_[t]] += mesh_.area[t];
    }
    const std::vector<dvec3> axes = chartAxes();
    seeds_.assign(count_, {asset::kNone, dvec3(0.0)});
    for (uint32_t t = 0; t < mesh_.size(); ++t) {
      const uint32_t c = chart_[t];
      const dvec3 away = mesh_.centroid[t] - centre[c] / std::max(area[c], 1e-300);
      const double distance = glm::dot(away, away);
      if (!(distance < nearest[c]) && seeds_[c].triangle != asset::kNone) continue;
      nearest[c] = distance;
      seeds_[c] = {t, axes[c]};
    }
  }

  std::vector<dvec3> chartAxes() const {
    std::vector<NormalSet> normals(count_);
    std::vector<dvec3> sum(count_, dvec3(0.0)), axes(count_);
    for (uint32_t t = 0; t < mesh_.size(); ++t) {
      normals[chart_[t]].add(mesh_.normal[t]);
      sum[chart_[t]] += mesh_.area[t] * mesh_.normal[t];
    }
    for (uint32_t c = 0; c < count_; ++c) axes[c] = normals[c].cone(sum[c], kNarrowCosine).axis;
    return axes;
  }

  /// Merging keeps rounded normals inside a cone, growing keeps them around an axis of the past: what is
  /// outside the hard limit now starts charts of its own.
  void expelOutliers() {
    for (bool any = true; any;) {
      any = false;
      const std::vector<dvec3> axes = chartAxes();
      for (uint32_t t = 0; t < mesh_.size(); ++t)
        if (glm::dot(mesh_.normal[t], axes[chart_[t]]) < kConeCosine) chart_[t] = asset::kNone, any = true;
      if (!any) return;
      seeds_.resize(count_);
      seedRest();
    }
  }

  std::vector<std::vector<uint32_t>> lists() const {
    std::vector<std::vector<uint32_t>> charts(count_);
    for (uint32_t t = 0; t < mesh_.size(); ++t) charts[chart_[t]].push_back(t);
    std::erase_if(charts, [](const auto& triangles) { return triangles.empty(); });
    return charts;
  }

  const ChartMesh& mesh_;
  Progress& progress_;
  std::vector<uint32_t> chart_;  // of each triangle
  std::vector<Seed> seeds_;      // of each chart
  uint32_t count_ = 0;
  std::priority_queue<Reach> queue_;
  uint64_t reached_ = 0;
};

}  // namespace

dvec3 chartAxis(const ChartMesh& mesh, std::span<const uint32_t> triangles) {
  NormalSet normals;
  dvec3 sum(0.0);
  for (const uint32_t t : triangles) {
    normals.add(mesh.normal[t]);
    sum += mesh.area[t] * mesh.normal[t];
  }
  return normals.cone(sum, kNarrowCosine).axis;
}

std::vector<std::vector<uint32_t>> growCharts(const ChartMesh& mesh, Progress& progress) {
  return Grower(mesh, progress).run();
}

}  // namespace boxlight
