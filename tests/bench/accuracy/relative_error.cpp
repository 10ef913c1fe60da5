// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/relative_error.h"

#include <cmath>

namespace boxlight::accuracy {

void RelativeError::add(const Radiances& value, const Reference& reference) {
  for (size_t l = 0; l < error_.size(); ++l) {
    const dvec3 difference = value[l] - reference.mean[l], variance = reference.variance[l];
    const double noise = variance.x + variance.y + variance.z;
    error_[l] += glm::dot(difference, difference) - noise;
    signal_[l] += glm::dot(reference.mean[l], reference.mean[l]) - noise;
  }
}

double RelativeError::mean(const std::vector<ProbeLight>& lights, bool sunLit) const {
  double sum = 0;
  uint32_t count = 0;
  for (size_t l = 0; l < lights.size(); ++l) {
    if (lights[l].sunLit != sunLit) continue;
    sum += signal_[l] > 0 ? std::sqrt(std::max(error_[l], 0.0) / signal_[l]) : 0.0;
    ++count;
  }
  return count ? sum / count : 0.0;
}

}  // namespace boxlight::accuracy
