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

double Rectangle::solidAngle() const { return rectangleSolidAngle(du, v0, v0 + dv); }

dvec3 meanDirection(double u0, double v0, double du, double dv) {
  const double t = kPiDouble * (v0 + 0.5 * dv), h = 0.5 * kPiDouble * dv, p = kPiDouble * (2 * u0 + du - 1);
  const double excess = h < 1e-3 ? 2.0 / 3.0 * h * h * h : h - std::sin(h) * std::cos(h);
  const double chord = std::sin(kPiDouble * du) / (kPiDouble * du);
  const double ring = chord * (std::sin(t) * std::cos(h) + excess / (2.0 * std::sin(t) * std::sin(h)));
  return {ring * std::cos(p), std::cos(t) * std::cos(h), ring * std::sin(p)};
}

float environmentOffset(float degrees) {
  const double turns = double(degrees) / 360.0;
  const float offset = float(turns - std::floor(turns));
  return offset < 1.0f ? offset : 0.0f;  // the rounding to float may reach 1
}

}  // namespace boxlight
