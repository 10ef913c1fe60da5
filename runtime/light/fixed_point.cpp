// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/fixed_point.h"

#include <cmath>

#include "common/light/light_map.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

constexpr int kExactTotalBits = 62;
// Of texels and products rounded to floats, and so that what a difference of rounded prefixes may be below 0
// has a place (shaders/boxlight.glsl).
constexpr double kMargin = 1.0 + 1e-5;
// Smaller, and factors would leave the range of floats: the darkest light that keeps all digits of a compact
// table has an energy of 2^-58.
constexpr double kSmallestUnit = 0x1p-100;

}  // namespace

FixedPoint chooseFixedPoint(double total, uvec2 size, SatScheme scheme) {
  const bool compact = scheme == SatScheme::compact;
  FixedPoint fixedPoint;
  if (total > 0.0)
    fixedPoint.unit = float(std::max(
        std::ldexp(total * kMargin, -(compact ? int(kPrefixBits) : kExactTotalBits)), kSmallestUnit));
  const double summed = std::ldexp(double(fixedPoint.unit), compact ? -int(kGuardBits) : 0);
  for (const double solidAngle : texelSolidAngles(size.x, size.y))
    fixedPoint.rowFactors.push_back(float(solidAngle / summed));
  return fixedPoint;
}

double strongestTotal(const Image& environment) {
  const dvec3 total = totalEnergy(environment);
  return std::max({total.x, total.y, total.z});
}

}  // namespace boxlight::gpu
