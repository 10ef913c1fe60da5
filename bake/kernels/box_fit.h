// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bake/transport/deposits.h"
#include "common/light/box.h"

namespace boxlight {

struct FitOptions {
  int boxes = 8;  ///< at most; 1 to 64
  /// Cells per side of the grid that box edges lie on, at most; 2 to 64. A grid has as many as there are
  /// deposits in all, but no fewer than 32 per side: finer ones cost time and fit the noise.
  int gridSize = 64;
  /// p in |integral of the residual|^2 / Omega^p. 1 is plain least squares, which overspends on peaks.
  float gainExponent = 0.7f;
  /// Variances of its own integral that a box's squared integral must beat. 0 fits noise as if it were
  /// signal.
  float noise = 4.0f;
  int refinements = 2;  ///< rounds in which every box moves again, given all the others
  int seeds = 2;        ///< starting boxes that are descended for each insertion; 1 to 16
};

/// Fits the boxes of Equation 2 to the deposits of one kernel. Reusable: it owns the scratch memory, so keep
/// one per thread.
class BoxFitter {
 public:
  explicit BoxFitter(FitOptions options);
  ~BoxFitter();
  BoxFitter(BoxFitter&&) noexcept;
  BoxFitter& operator=(BoxFitter&&) noexcept;

  /// At most options.boxes boxes in order of falling energy, each with non-negative energies that sum to the
  /// mean throughput, sum(throughput) / pathCount, in every channel; pathCount >= deposits.size().
  /// Empty if there is no energy. Deterministic.
  std::vector<Box> fit(std::span<const Deposit> deposits, uint64_t pathCount) {
    return fit(deposits, pathCount, options_.boxes);
  }
  /// The same with at most `boxes` boxes, no more than options.boxes.
  std::vector<Box> fit(std::span<const Deposit> deposits, uint64_t pathCount, int boxes);

 private:
  struct Scratch;
  FitOptions options_;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace boxlight
