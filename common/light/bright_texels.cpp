// SPDX-License-Identifier: Apache-2.0
#include "common/light/bright_texels.h"

#include <algorithm>
#include <array>
#include <bit>

namespace boxlight {
namespace {

constexpr int kBins = 256;

/// By the first bits of the square, as shaders/bright_texels.comp does it; negative for what is too faint.
int binOf(double strength) {
  const auto bits = [](double s) { return int(std::bit_cast<uint32_t>(float(s * s)) >> 20); };
  return std::min(bits(strength) - bits(kLeastBright), kBins - 1);
}

}  // namespace

std::vector<uint32_t> findBrightTexels(std::span<const double> strengths) {
  std::array<uint32_t, kBins> counts{};
  for (const double strength : strengths)
    if (const int bin = binOf(strength); bin >= 0) ++counts[size_t(bin)];
  int least = kBins;
  for (uint32_t sum = 0; least > 0 && (sum += counts[size_t(least - 1)]) <= kBrightTexels;) --least;
  std::vector<uint32_t> found;
  for (size_t i = 0; i < strengths.size(); ++i)
    if (binOf(strengths[i]) >= least) found.push_back(uint32_t(i));
  return found;
}

}  // namespace boxlight
