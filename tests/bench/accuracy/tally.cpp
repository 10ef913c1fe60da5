// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/tally.h"

namespace boxlight::accuracy {

std::vector<Row> tally(const std::vector<Sample>& samples, const std::vector<ProbeLight>& lights) {
  std::vector<Row> rows;
  if (samples.empty()) return rows;
  for (size_t t = 0; t < samples.front().trials.size(); ++t) {
    Row row = samples.front().trials[t].row;
    RelativeError error(lights.size());
    row.milliseconds = 0;
    for (const Sample& sample : samples) {
      error.add(sample.trials[t].value, sample.reference);
      row.milliseconds += sample.trials[t].row.milliseconds / double(samples.size());
    }
    row.soft = error.mean(lights, false);
    row.sunLit = error.mean(lights, true);
    row.samples = uint32_t(samples.size());
    rows.push_back(row);
  }
  return rows;
}

}  // namespace boxlight::accuracy
