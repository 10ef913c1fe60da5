// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/fixed_point.h"

#include <cmath>

#include "common/light/light_map.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

// One bit less than a prefix holds: differences are decoded as signed numbers.
constexpr int kTotalBits = kPrefixBits - 1;
// Past these the factors would leave the range of normal floats. The darkest map that keeps all digits has an
// energy of 2^-60.
constexpr int kSmallestExponent = -100, kLargestExponent = 100;

/// Radiance times steradian of the strongest channel.
double strongestTotal(const Image& lightMap, const std::vector<double>& solidAngles) {
  dvec3 total(0.0);
  for (uint32_t y = 0; y < lightMap.height; ++y)
    for (uint32_t x = 0; x < lightMap.width; ++x) total += solidAngles[y] * dvec3(rgbAt(lightMap, x, y));
  return std::max({total.x, total.y, total.z});
}

}  // namespace

FixedPoint chooseFixedPoint(const Image& lightMap) {
  const auto solidAngles = texelSolidAngles(lightMap.width, lightMap.height);
  constexpr double kRoundingMargin = 1.0 + 1e-6;  // the products that are summed are rounded to floats
  const double total = strongestTotal(lightMap, solidAngles) * kRoundingMargin;
  const int exponent =
      total > 0.0 ? std::clamp(kTotalBits - 1 - std::ilogb(total), kSmallestExponent, kLargestExponent) : 0;
  FixedPoint fixedPoint;
  fixedPoint.unit = std::ldexp(1.0f, -exponent);
  for (const double solidAngle : solidAngles)
    fixedPoint.rowFactors.push_back(float(std::ldexp(solidAngle, exponent + int(kGuardBits))));
  return fixedPoint;
}

}  // namespace boxlight::gpu
