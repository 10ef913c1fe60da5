// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/deposit_grid.h"

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kLeastSize = 32;

int rasterColumn(vec2 uv) { return std::clamp(int(uv.x * float(kRasterColumns)), 0, kRasterColumns - 1); }
int rasterRow(vec2 uv) { return std::clamp(int(uv.y * float(kRasterRows)), 0, kRasterRows - 1); }

/// Lines at the quantiles of half the energy's density and half the uniform one: at most cells + 1, from 0 to
/// energy.size(). `energy` sums to 1.
void quantileLines(const std::vector<float>& energy, int cells, std::vector<int>& lines) {
  const int size = int(energy.size());
  const float perCell = 1.0f / float(cells), uniform = 0.5f / float(size);
  lines.assign(1, 0);
  float below = 0.0f;
  int next = 1;  // the quantile to reach
  for (int i = 0; i < size; ++i) {
    const float above = below + 0.5f * energy[i] + uniform;
    // A spike worth two lines is fenced in on both sides: a delta gets the narrowest cell there is.
    if (above - below >= 2.0f * perCell && lines.back() != i) lines.push_back(i);
    if (above >= float(next) * perCell && i + 1 < size) {
      lines.push_back(i + 1);
      next = int(above * float(cells)) + 1;
    }
    below = above;
  }
  lines.push_back(size);
}

void invertLines(const std::vector<int>& lines, std::vector<int>& cellOfRaster) {
  for (size_t cell = 0; cell + 1 < lines.size(); ++cell)
    std::fill(cellOfRaster.begin() + lines[cell], cellOfRaster.begin() + lines[cell + 1], int(cell));
}

}  // namespace

DepositGrid::DepositGrid(int size)
    : size_(size),
      columnOfRaster_(kRasterColumns),
      rowOfRaster_(kRasterRows),
      columnEnergy_(kRasterColumns),
      rowEnergy_(kRasterRows) {}

bool DepositGrid::build(std::span<const Deposit> deposits, float noise) {
  total_ = dvec3(0.0);
  for (const Deposit& deposit : deposits) total_ += dvec3(deposit.throughput);
  const double sum = total_.x + total_.y + total_.z;
  if (!(sum > 0.0)) return false;
  scale_ = 1.0 / sum;
  chooseLines(deposits);
  bin(deposits, noise);
  return true;
}

int DepositGrid::sizeFor(size_t deposits) const {
  return std::min(size_, std::max(kLeastSize, int(std::sqrt(double(deposits)))));
}

void DepositGrid::chooseLines(std::span<const Deposit> deposits) {
  std::fill(columnEnergy_.begin(), columnEnergy_.end(), 0.0f);
  std::fill(rowEnergy_.begin(), rowEnergy_.end(), 0.0f);
  for (const Deposit& deposit : deposits) {
    const dvec3 t = dvec3(deposit.throughput) * scale_;
    const float energy = float(t.x + t.y + t.z);
    columnEnergy_[rasterColumn(deposit.uv)] += energy;
    rowEnergy_[rasterRow(deposit.uv)] += energy;
  }
  const int size = sizeFor(deposits.size());
  quantileLines(columnEnergy_, size, columnLines_);
  quantileLines(rowEnergy_, size, rowLines_);
  invertLines(columnLines_, columnOfRaster_);
  invertLines(rowLines_, rowOfRaster_);
  for (int x = 1, count = int(columnLines_.size()) - 1; x <= count; ++x)
    columnLines_.push_back(columnLines_[x] + kRasterColumns);
  zoneAbove_.resize(rowLines_.size());
  for (size_t y = 0; y < rowLines_.size(); ++y)
    zoneAbove_[y] = rectangleSolidAngle(1.0, 0.0, double(rowLines_[y]) / kRasterRows);
}

void DepositGrid::bin(std::span<const Deposit> deposits, float noise) {
  cells_.assign(size_t(columns()) * rows(), splat(0.0f));
  for (const Deposit& deposit : deposits) {
    const vec3 t(dvec3(deposit.throughput) * scale_);
    const int x = columnOfRaster_[rasterColumn(deposit.uv)], y = rowOfRaster_[rasterRow(deposit.uv)];
    cells_[size_t(y) * columns() + x] += lanes(t, noise * glm::dot(t, t));
  }
}

GridBox DepositGrid::bounds() const {
  std::vector<bool> columnUsed(columns()), rowUsed(rows());
  for (int y = 0; y < rows(); ++y)
    for (int x = 0; x < columns(); ++x) {
      const Lanes& sum = cell(x, y);
      if (sum[0] + sum[1] + sum[2] > 0.0f) columnUsed[x] = rowUsed[y] = true;
    }
  GridBox box{0, columns(), 0, rows()};
  while (!rowUsed[box.y0]) ++box.y0;
  while (!rowUsed[box.y1 - 1]) --box.y1;
  // What remains outside of the longest gap between used columns, across the seam too.
  for (int start = 0, longest = 0; start < columns(); ++start) {
    int end = start;
    while (end < start + columns() && !columnUsed[end % columns()]) ++end;
    const int gap = columnLine(end) - columnLine(start);
    if (gap <= longest) continue;
    longest = gap;
    box.x0 = end % columns();
    box.x1 = box.x0 + columns() - (end - start);
  }
  return box;
}

Box DepositGrid::toBox(const GridBox& box) const {
  Box result;
  result.u0 = float(columnLine(box.x0)) / float(kRasterColumns);
  result.du = width(box.x0, box.x1);
  if (box.x1 - box.x0 == columns()) result.u0 = 0.0f;
  result.v0 = float(rowLine(box.y0)) / float(kRasterRows);
  result.dv = float(rowLine(box.y1) - rowLine(box.y0)) / float(kRasterRows);
  return result;
}

}  // namespace boxlight
