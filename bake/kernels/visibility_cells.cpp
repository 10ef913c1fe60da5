// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_cells.h"

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kColumns = VisibilityCells::kColumns, kRows = VisibilityCells::kRows;
constexpr int kSeeds = 3;

size_t cellOf(vec3 direction) {
  const vec2 uv = directionToUv(direction);
  const int x = std::clamp(int(uv.x * float(kColumns)), 0, kColumns - 1);
  const int y = std::clamp(int(uv.y * float(kRows)), 0, kRows - 1);
  return size_t(y) * kColumns + size_t(x);
}

constexpr int kSub = 2;  // samples of a cell, each way

/// Directions of those of all cells.
const std::vector<vec3>& cellSamples() {
  static const std::vector<vec3> samples = [] {
    std::vector<vec3> made;
    for (int i = 0; i < kColumns * kRows * kSub * kSub; ++i) {
      const int cell = i / (kSub * kSub), sample = i % (kSub * kSub);
      made.push_back(
          uvToDirection({(float(cell % kColumns) + (float(sample % kSub) + 0.5f) / kSub) / kColumns,
                         (float(cell / kColumns) + (float(sample / kSub) + 0.5f) / kSub) / kRows}));
    }
    return made;
  }();
  return samples;
}

/// Integral of (n.w)^2 over the part of a cell that lies below the horizon.
double belowHorizon(int cell, vec3 normal) {
  double sum = 0;
  for (int i = 0; i < kSub * kSub; ++i) {
    const double cosine = double(glm::dot(cellSamples()[size_t(cell * kSub * kSub + i)], normal));
    if (cosine < 0) sum += cosine * cosine;
  }
  const int row = cell / kColumns;
  return sum / (kSub * kSub) * rectangleSolidAngle(1.0 / kColumns, double(row) / kRows, (row + 1.0) / kRows);
}

}  // namespace

dvec2 VisibilityCells::Table::sum(const GridBox& box) const {
  const dvec2 right = box.x1 <= kColumns
                          ? leftOf(box.x1, box.y0, box.y1)
                          : leftOf(kColumns, box.y0, box.y1) + leftOf(box.x1 - kColumns, box.y0, box.y1);
  return right - leftOf(box.x0, box.y0, box.y1);
}

void VisibilityCells::Table::build(const std::vector<dvec2>& cells) {
  for (int y = 0; y < kRows; ++y) {
    dvec2 row(0);
    for (int x = 0; x < kColumns; ++x) {
      row += cells[size_t(y) * kColumns + x];
      sums[size_t(y + 1) * (kColumns + 1) + x + 1] = sums[size_t(y) * (kColumns + 1) + x + 1] + row;
    }
  }
}

VisibilityCells::VisibilityCells(std::span<const FirstDirection> first, vec3 normal)
    : cells_(size_t(kColumns) * kRows, dvec2(0)), weights_(cells_.size()) {
  size_t straight = 0;
  for (const auto& [towards, isStraight] : first) {
    straight += isStraight;
    const double cosine = std::max(double(glm::dot(towards, normal)), 0.0);
    cells_[cellOf(towards)] += dvec2(isStraight ? cosine : 0.0, cosine);
    worth_ += cosine;
  }
  straightPart_ = double(straight) / double(first.size());
  for (size_t i = 0; i < cells_.size(); ++i)
    weights_[i] = cells_[i].y + double(first.size()) / kPiDouble * belowHorizon(int(i), normal);
  data_.build(cells_);
}

double VisibilityCells::data(const GridBox& box, double open) const {
  const dvec2 sum = data_.sum(box);
  return sum.x - open * sum.y;
}

void VisibilityCells::setResidual(double open, const std::vector<GridBox>& boxes,
                                  const std::vector<double>& amplitudes) {
  paint_.assign(cells_.size(), 0.0);
  for (size_t j = 0; j < boxes.size(); ++j)
    for (int y = boxes[j].y0; y < boxes[j].y1; ++y)
      for (int x = boxes[j].x0; x < boxes[j].x1; ++x)
        paint_[size_t(y) * kColumns + size_t(x % kColumns)] += amplitudes[j];
  std::vector<dvec2> cells(cells_.size());
  for (size_t i = 0; i < cells.size(); ++i)
    cells[i] = {cells_[i].x - open * cells_[i].y - paint_[i] * weights_[i], weights_[i]};
  residual_.build(cells);
}

double VisibilityCells::overlap(const GridBox& a, const GridBox& b) const {
  const int y0 = std::max(a.y0, b.y0), y1 = std::min(a.y1, b.y1);
  double sum = 0;
  for (int turn = -1; turn <= 1 && y0 < y1; ++turn) {
    const int x0 = std::max(a.x0, b.x0 + turn * kColumns), x1 = std::min(a.x1, b.x1 + turn * kColumns);
    if (x0 >= x1) continue;
    const int back = x0 >= kColumns ? kColumns : 0;
    sum += residual_.sum({x0 - back, x1 - back, y0, y1}).y;
  }
  return sum;
}

/// The whole sphere is for the hemisphere to mean; without it nothing can be taken away.
double VisibilityCells::gain(const GridBox& box) const {
  if (box.x1 - box.x0 == kColumns && box.y1 - box.y0 == kRows) return 0;
  const dvec2 sum = residual_.sum(box);
  if (straightPart_ <= kOpenPart && sum.x < 0) return 0;
  return sum.y > 0 ? sum.x * sum.x / sum.y : 0;
}

double VisibilityCells::find(GridBox& best) const {
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

double VisibilityCells::descend(GridBox& box, int sweeps) const {
  double best = gain(box);
  while (sweeps-- > 0 && move(box, best)) {
  }
  return best;
}

/// Moves each edge to where the gain is largest. Did any move?
bool VisibilityCells::move(GridBox& box, double& best) const {
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

Box VisibilityCells::toBox(const GridBox& box) const {
  const float columns = kColumns, rows = kRows;
  return {float(box.x0) / columns, float(box.y0) / rows, float(box.x1 - box.x0) / columns,
          float(box.y1 - box.y0) / rows};
}

}  // namespace boxlight
