// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/bench/accuracy/probe_light.h"

namespace boxlight::accuracy {

/// Radiance under every probe light.
using Radiances = std::vector<dvec3>;

/// What is true, and the variance that is left in it.
struct Reference {
  Radiances mean;
  Radiances variance;  ///< of the mean, unbiased; of single samples it may be far off, of their sum it is not
};

/// Error over samples (a texel and a view each). For one light sqrt(sum (L' - L)^2 / sum L^2), over samples
/// and channels; then the mean over the lights of a class. The reference's own variance is subtracted from
/// both sums.
class RelativeError {
 public:
  explicit RelativeError(size_t lights) : error_(lights), signal_(lights) {}
  void add(const Radiances& value, const Reference& reference);
  double mean(const std::vector<ProbeLight>& lights, bool sunLit) const;

 private:
  std::vector<double> error_, signal_;
};

}  // namespace boxlight::accuracy
