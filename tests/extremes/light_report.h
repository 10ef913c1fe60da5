// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/extremes/extreme_maps.h"
#include "tests/extremes/light_probe.h"

namespace boxlight::test {

/// What the pages promises of an integral I of a map whose light is E in all: it is off by no more than
/// kRounded I + (compact table) 2^-41 E, and by the float rounding of the smallest number.
inline constexpr double kRounded = 2e-6;
double bound(double integral, double total, gpu::SatScheme scheme);

/// Worst relative error over boxes with light in them, and whether every box keeps the bound.
struct Errors {
  double worst = 0;
  bool bounded = true;
};
Errors errorsOf(const Image& map, const std::vector<GridBox>& boxes, const std::vector<Integral>& found,
                gpu::SatScheme scheme);

/// A row of the table in docs/numerics.md: of one-texel boxes the bound and what 42 bits, 64 bits and fp32
/// do; of all other boxes what 42 and 64 bits do.
struct ReportRow {
  std::string map;
  double bound = 0, compact = 0, exact = 0, fp32 = 0, anyCompact = 0, anyExact = 0;
  bool bounded = true;
};
std::vector<ReportRow> measureLight(gpu::Device& device);
/// The rows as they stand in the page.
std::string toMarkdown(const std::vector<ReportRow>& rows);

}  // namespace boxlight::test
