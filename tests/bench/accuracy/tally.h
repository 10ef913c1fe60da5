// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "tests/bench/accuracy/measure.h"

namespace boxlight::accuracy {

/// What one sample (a texel and a view) gave by every method, in the order of first use.
struct Sample {
  struct Trial {
    Row row;  ///< what the figure will be called; errors are still missing
    Radiances value;
  };
  Reference reference;
  std::vector<Trial> trials;
};

/// Errors over all samples; every sample made the same trials in the same order.
std::vector<Row> tally(const std::vector<Sample>& samples, const std::vector<ProbeLight>& lights);

}  // namespace boxlight::accuracy
