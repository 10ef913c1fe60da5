// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_search.h"

namespace boxlight {
namespace {

constexpr int kColumns = VisibilityTable::kColumns, kRows = VisibilityTable::kRows;
constexpr int kSeeds = 3;

}  // namespace

void VisibilitySearch::build(const std::vector<dvec2>& cells, bool takesAway) {
  takesAway_ = takesAway;
  table_.build(cells);
}

/// The whole sphere is for the hemisphere to mean.
double VisibilitySearch::gain(const GridBox& box) const {
  if (box.x1 - box.x0 == kColumns && box.y1 - box.y0 == kRows) return 0;
  const dvec2 sum = table_.sum(box);
  if (!takesAway_ && sum.x < 0) return 0;
  return sum.y > 0 ? sum.x * sum.x / sum.y : 0;
}

double VisibilitySearch::find(GridBox& best) const {
  std::vector<std::pair<double, GridBox>> seeds;
  for (int height = 2; height <= kRows; height *= 2)
    for (int y = 0; y < kRows; y += height)
      for (int width = 2; width <= kColumns; width *= 2)
        for (int x = 0; x < kColumns; x += width) {
          const GridBox box{x, x + width, y, y + height};
          const double g = gain(box);
          if (seeds.size() == kSeeds && g <= seeds.back().first) continue;
          if (seeds.size() == kSeeds) seeds.pop_back();
          auto place = seeds.begin();
          while (place != seeds.end() && place->first >= g) ++place;
          seeds.insert(place, {g, box});
        }
  double bestGain = 0;
  for (auto [g, box] : seeds)
    if (g = descend(box, 6); g > bestGain) bestGain = g, best = box;
  return bestGain;
}

double VisibilitySearch::descend(GridBox& box, int sweeps) const {
  double best = gain(box);
  while (sweeps-- > 0 && move(box, best)) {
  }
  return best;
}

/// Moves each edge to where the gain is largest. Did any move?
bool VisibilitySearch::move(GridBox& box, double& best) const {
  const double before = best;
  const auto offer = [&](GridBox candidate, GridBox& kept) {
    if (candidate.x0 >= kColumns) candidate.x0 -= kColumns, candidate.x1 -= kColumns;
    if (candidate.x0 < 0) candidate.x0 += kColumns, candidate.x1 += kColumns;
    if (const double g = gain(candidate); g > best) best = g, kept = candidate;
  };
  GridBox kept = box;
  for (int x1 = box.x0 + 1; x1 <= box.x0 + kColumns; ++x1) offer({box.x0, x1, box.y0, box.y1}, kept);
  box = kept;
  for (int x0 = box.x1 - kColumns; x0 < box.x1; ++x0) offer({x0, box.x1, box.y0, box.y1}, kept);
  box = kept;
  for (int y1 = box.y0 + 1; y1 <= kRows; ++y1) offer({box.x0, box.x1, box.y0, y1}, kept);
  box = kept;
  for (int y0 = 0; y0 < box.y1; ++y0) offer({box.x0, box.x1, y0, box.y1}, kept);
  box = kept;
  return best > before * (1 + 1e-6);
}

}  // namespace boxlight
