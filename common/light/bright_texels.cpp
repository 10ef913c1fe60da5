// SPDX-License-Identifier: Apache-2.0
#include "common/light/bright_texels.h"

#include <algorithm>
#include <array>
#include <bit>

namespace boxlight {
namespace {

constexpr int kBins = 256;

/// Of the square over the least, by its first bits, as shaders/bright_texels.comp does it; negative for what
/// is too faint.
int binOf(double strength) {
  const double ratio = strength / kLeastBright;
  const auto bits = [](double square) { return int(std::bit_cast<uint32_t>(float(square)) >> 20); };
  return std::min(bits(ratio * ratio) - bits(1.0), kBins - 1);
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
