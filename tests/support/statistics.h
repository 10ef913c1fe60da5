// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

// p-values of the tests that judge random numbers: how likely is a statistic at least as bad if all is right?

namespace boxlight::test {

/// How often a whole suite of right code may fail for another seed; seeds are fixed, so it passes or it does
/// not.
inline constexpr double kSignificance = 0.01;

/// Level of each of `count` independent tests so that all of them together keep `significance`: Sidak,
/// "Rectangular confidence regions for the means of multivariate normal distributions", JASA 62, 1967.
inline double sidakLevel(int count, double significance = kSignificance) {
  return -std::expm1(std::log1p(-significance) / count);
}

/// Probability that chi-square of `degrees` degrees of freedom is at least `statistic`: by the cube root of
/// Wilson and Hilferty, "The distribution of chi-square", PNAS 17, 1931, for the many degrees used here
/// within a few percent of the p-value.
inline double chiSquareP(double statistic, int degrees) {
  const double spread = 2.0 / (9.0 * degrees);
  return 0.5 * std::erfc((std::cbrt(statistic / degrees) - 1.0 + spread) / std::sqrt(2.0 * spread));
}

/// Two-sided probability of a normal deviate of at least |z|.
inline double normalP(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

}  // namespace boxlight::test
