// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_cells.h"

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kColumns = VisibilityTable::kColumns, kRows = VisibilityTable::kRows;

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

VisibilityCells::VisibilityCells(std::span<const FirstDirection> first, vec3 normal)
    : cells_(VisibilityTable::kCells, dvec2(0)), weighted_(cells_.size()) {
  size_t straight = 0;
  for (const auto& [towards, isStraight] : first) {
    straight += isStraight;
    const double cosine = std::max(double(glm::dot(towards, normal)), 0.0);
    cells_[cellOf(towards)] += dvec2(isStraight ? cosine : 0.0, cosine);
    worth_ += cosine;
  }
  straightPart_ = double(straight) / double(first.size());
  for (size_t i = 0; i < cells_.size(); ++i)
    weighted_[i].y = cells_[i].y + double(first.size()) / kPiDouble * belowHorizon(int(i), normal);
  weights_.build(weighted_);
  data_.build(cells_);
}

double VisibilityCells::data(const GridBox& box, double open) const {
  const dvec2 sum = data_.sum(box);
  return sum.x - open * sum.y;
}

/// Its two runs of cells in a row, across the seam.
template <class Run>
void VisibilityCells::forRuns(const GridBox& box, const Run& run) {
  for (int y = box.y0; y < box.y1; ++y) {
    float* row = &paint_[size_t(y) * kColumns];
    run(row + box.x0, row + std::min(box.x1, kColumns));
    if (box.x1 > kColumns) run(row, row + box.x1 - kColumns);
  }
}

void VisibilityCells::paint(const std::vector<GridBox>& boxes, const std::vector<double>& amplitudes) {
  paint_.assign(cells_.size(), 0.0f);
  for (size_t j = 0; j < boxes.size(); ++j)
    forRuns(boxes[j], [a = float(amplitudes[j])](float* cell, float* end) {
      for (; cell < end; ++cell) *cell += a;
    });
}

double VisibilityCells::takeAway(const GridBox& box, double step) {
  float low = 1e9f, high = -1e9f;
  forRuns(box, [&](const float* cell, const float* end) {
    for (; cell < end; ++cell) low = std::min(low, *cell), high = std::max(high, *cell);
  });
  const float bounded = float(step < 0 ? std::min(std::max(step, -1.0 - double(low)), 0.0)
                                       : std::max(std::min(step, -double(high)), 0.0));
  forRuns(box, [bounded](float* cell, const float* end) {
    for (; cell < end; ++cell) *cell += bounded;
  });
  return double(bounded);
}

bool VisibilityCells::isPaintBounded() const {
  constexpr float kRounding = 1e-3f;
  const auto [low, high] = std::minmax_element(paint_.begin(), paint_.end());
  return *low >= -1.0f - kRounding && *high <= kRounding;
}

const std::vector<dvec2>& VisibilityCells::residual(double open, const std::vector<GridBox>& boxes,
                                                    const std::vector<double>& amplitudes) {
  paint(boxes, amplitudes);
  for (size_t i = 0; i < cells_.size(); ++i)
    weighted_[i].x = cells_[i].x - open * cells_[i].y - double(paint_[i]) * weighted_[i].y;
  return weighted_;
}

double VisibilityCells::overlap(const GridBox& a, const GridBox& b) const {
  const int y0 = std::max(a.y0, b.y0), y1 = std::min(a.y1, b.y1);
  double sum = 0;
  for (int turn = -1; turn <= 1 && y0 < y1; ++turn) {
    const int x0 = std::max(a.x0, b.x0 + turn * kColumns), x1 = std::min(a.x1, b.x1 + turn * kColumns);
    if (x0 >= x1) continue;
    const int back = x0 >= kColumns ? kColumns : 0;
    sum += weights_.sum({x0 - back, x1 - back, y0, y1}).y;
  }
  return sum;
}

Box VisibilityCells::toBox(const GridBox& box) const {
  const float columns = kColumns, rows = kRows;
  return {float(box.x0) / columns, float(box.y0) / rows, float(box.x1 - box.x0) / columns,
          float(box.y1 - box.y0) / rows};
}

}  // namespace boxlight
