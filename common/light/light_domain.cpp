// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_domain.h"

#include <cmath>

namespace boxlight {

vec2 directionToUv(vec3 direction) {
  float u = 0.5f + std::atan2(direction.z, direction.x) / (2.0f * kPi);
  if (u >= 1.0f) u -= 1.0f;
  // atan2 keeps all digits near the poles, where acos loses half of them.
  const float v = std::atan2(std::hypot(direction.x, direction.z), direction.y) / kPi;
  return {u, v};
}

vec3 uvToDirection(vec2 uv) {
  const double phi = (uv.x - 0.5) * 2.0 * kPiDouble, theta = uv.y * kPiDouble;
  const double ring = std::sin(theta);
  return {float(ring * std::cos(phi)), float(std::cos(theta)), float(ring * std::sin(phi))};
}

double rectangleSolidAngle(double du, double v0, double v1) {
  // cos a - cos b as a product: exact for thin rectangles, where the difference of cosines cancels.
  const double a = v0 * kPiDouble, b = v1 * kPiDouble;
  return 4.0 * kPiDouble * du * std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a));
}

float environmentOffset(float degrees) {
  const double turns = double(degrees) / 360.0;
  const float offset = float(turns - std::floor(turns));
  return offset < 1.0f ? offset : 0.0f;  // the rounding to float may reach 1
}

}  // namespace boxlight
