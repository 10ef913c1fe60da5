// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/chart_merge.h"

#include <algorithm>
#include <tuple>

#include "bake/scene/normal_set.h"

namespace boxlight {
namespace {

constexpr int kMostRounds = 16;
constexpr double kLeastShare = 0.12;  // of the smaller border: below, the joint chart would be two on a stalk

struct Region {
  dvec3 sum{0.0};  // of area times normal
  NormalSet normals;
  double perimeter = 0;
};

struct Border {
  uint32_t a, b;
  double length, share;
};

class Merger {
 public:
  Merger(const ChartMesh& mesh, std::vector<uint32_t>& chart, uint32_t count)
      : mesh_(mesh), chart_(chart), count_(count) {}

  uint32_t run() {
    for (int round = 0; round < kMostRounds; ++round) {
      measure();
      if (!mergePairs()) break;
    }
    return count_;
  }

 private:
  void measure() {
    regions_.assign(count_, {});
    borders_.clear();
    for (uint32_t t = 0; t < mesh_.size(); ++t) {
      Region& region = regions_[chart_[t]];
      region.sum += mesh_.area[t] * mesh_.normal[t];
      region.normals.add(mesh_.normal[t]);
      for (int k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbour[t][k];
        if (other != asset::kNone && chart_[other] == chart_[t]) continue;
        const double length = mesh_.edgeLength(t, k);
        region.perimeter += length;
        if (other != asset::kNone && chart_[t] < chart_[other])
          borders_.push_back({chart_[t], chart_[other], length, 0});
      }
    }
    rank();
  }

  /// One entry a pair of charts, the most shared first.
  void rank() {
    std::stable_sort(borders_.begin(), borders_.end(), [](const Border& x, const Border& y) {
      return std::tie(x.a, x.b) < std::tie(y.a, y.b);
    });
    std::vector<Border> pairs;
    for (const Border& border : borders_) {
      if (pairs.empty() || pairs.back().a != border.a || pairs.back().b != border.b) {
        pairs.push_back(border);
      } else {
        pairs.back().length += border.length;
      }
    }
    for (Border& pair : pairs)
      pair.share = pair.length / std::min(regions_[pair.a].perimeter, regions_[pair.b].perimeter);
    std::erase_if(pairs, [](const Border& pair) { return pair.share < kLeastShare; });
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Border& x, const Border& y) { return x.share > y.share; });
    borders_.swap(pairs);
  }

  bool fits(const Border& pair) const {
    NormalSet both = regions_[pair.a].normals;
    both.add(regions_[pair.b].normals);
    return both.cone(regions_[pair.a].sum + regions_[pair.b].sum, kGrowCosine).cosine >= kGrowCosine;
  }

  /// Every chart merges at most once a round: afterwards its borders are others.
  bool mergePairs() {
    std::vector<uint32_t> target(count_);
    std::vector<bool> done(count_, false);
    for (uint32_t c = 0; c < count_; ++c) target[c] = c;
    bool any = false;
    for (const Border& pair : borders_) {
      if (done[pair.a] || done[pair.b] || !fits(pair)) continue;
      target[pair.b] = pair.a;
      done[pair.a] = done[pair.b] = any = true;
    }
    std::vector<uint32_t> number(count_, 0);
    uint32_t next = 0;
    for (uint32_t c = 0; c < count_; ++c) number[c] = target[c] == c ? next++ : number[target[c]];
    for (uint32_t& c : chart_) c = number[c];
    count_ = next;
    return any;
  }

  const ChartMesh& mesh_;
  std::vector<uint32_t>& chart_;
  uint32_t count_;
  std::vector<Region> regions_;
  std::vector<Border> borders_;
};

}  // namespace

uint32_t mergeCharts(const ChartMesh& mesh, std::vector<uint32_t>& chart, uint32_t count) {
  return Merger(mesh, chart, count).run();
}

}  // namespace boxlight
