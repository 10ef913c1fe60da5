// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/kernels/lanes.h"
#include "bake/transport/deposits.h"
#include "common/light/box.h"

namespace boxlight {

/// Half-open ranges of cells.
///   Columns are periodic: 0 <= x0 < columns, x0 < x1 <= x0 + columns.
///   Rows are not:         0 <= y0 < y1 <= rows.
struct GridBox {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
};

/// Grid lines lie on this raster: .35 degrees, a pixel of a 1024 x 512 light map, exact in PackedBox.
inline constexpr int kRasterColumns = 1024;
inline constexpr int kRasterRows = 512;

/// Deposits binned into a rectilinear grid over the light domain whose lines crowd where the energy is: half
/// of them are quantiles of the deposits, half are spread evenly. All energies are scaled so that the
/// deposits sum to 1 over the three channels.
class DepositGrid {
 public:
  /// At most size x size cells, and beyond 32 x 32 no more than deposits.
  explicit DepositGrid(int size);

  /// False if the deposits carry no energy. Each cell's last lane is the sum of noise * |throughput|^2.
  bool build(std::span<const Deposit> deposits, float noise);

  int columns() const { return int(columnLines_.size()) / 2; }
  int rows() const { return int(rowLines_.size()) - 1; }
  /// Sum over the deposits in a cell.
  const Lanes& cell(int x, int y) const { return cells_[size_t(y) * columns() + x]; }
  /// Sum of the deposits as given, per channel.
  const dvec3& total() const { return total_; }

  /// Raster coordinate of a line; columns run on past the seam, up to 2 columns().
  int columnLine(int x) const { return columnLines_[x]; }
  int rowLine(int y) const { return rowLines_[y]; }
  /// Fraction of the full turn between column lines x0 < x1.
  float width(int x0, int x1) const {
    return float(columnLine(x1) - columnLine(x0)) * (1.0f / kRasterColumns);
  }
  /// Solid angle between row lines y0 < y1 over the full turn, steradians.
  float zone(int y0, int y1) const { return float(zoneAbove_[y1] - zoneAbove_[y0]); }
  float solidAngle(const GridBox& box) const { return width(box.x0, box.x1) * zone(box.y0, box.y1); }

  /// The smallest box around all deposits.
  GridBox bounds() const;
  /// The box in the light domain, without energy.
  Box toBox(const GridBox& box) const;

 private:
  int sizeFor(size_t deposits) const;
  void chooseLines(std::span<const Deposit> deposits);
  void bin(std::span<const Deposit> deposits, float noise);

  int size_;
  double scale_ = 1.0;
  dvec3 total_{0.0};
  std::vector<int> columnLines_;  // raster coordinates, twice around
  std::vector<int> rowLines_;
  std::vector<double> zoneAbove_;                  // [row line]
  std::vector<int> columnOfRaster_, rowOfRaster_;  // the cell that a raster cell lies in
  std::vector<float> columnEnergy_, rowEnergy_;    // marginals on the raster
  std::vector<Lanes> cells_;
};

}  // namespace boxlight
