// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace boxlight {

/// Texels of the moments' lattice that hemispheres and lobes count one by one, at most.
inline constexpr uint32_t kBrightTexels = 32;
/// Part of the whole light that such a texel has at least.
inline constexpr double kLeastBright = 0x1p-12;

/// Indices, ascending, of the brightest texels: those above the lowest of a row of thresholds, about
/// sixteen an octave, that no more than kBrightTexels exceed. Of a light without a sun there are none.
/// `strengths`: of all texels, as parts of the whole light.
std::vector<uint32_t> findBrightTexels(std::span<const double> strengths);

}  // namespace boxlight
