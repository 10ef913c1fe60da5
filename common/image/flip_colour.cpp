// SPDX-License-Identifier: Apache-2.0
#include "common/image/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace boxlight::flip {
namespace {

// The matrix is that of sRGB; the white is what it makes of (1, 1, 1).
const glm::dmat3 kXyz =
    glm::transpose(glm::dmat3(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
                              2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
                              1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
const dvec3 kWhite = kXyz * dvec3(1);

double labRoot(double t) {
  constexpr double kBend = 6.0 / 29;
  return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3 * kBend * kBend) + 4.0 / 29;
}

double compressedDistance(dvec3 a, dvec3 b) {
  constexpr double kExponent = 0.7;
  const dvec3 d = a - b;
  return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), kExponent);
}

}  // namespace

dvec3 toOpponent(dvec3 rgb) {
  const dvec3 p = kXyz * rgb / kWhite;
  return {116 * p.y - 16, 500 * (p.x - p.y), 200 * (p.y - p.z)};
}

dvec3 fromOpponent(dvec3 c) {
  const double y = (c.x + 16) / 116;
  return glm::inverse(kXyz) * (dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

dvec3 toHuntLab(dvec3 rgb) {
  const dvec3 p = kXyz * rgb / kWhite, f(labRoot(p.x), labRoot(p.y), labRoot(p.z));
  const double lightness = 116 * f.y - 16;
  return {lightness, 0.01 * lightness * 500 * (f.x - f.y), 0.01 * lightness * 200 * (f.y - f.z)};
}

double colourError(dvec3 a, dvec3 b) {
  constexpr double kShare = 0.4, kTaken = 0.95;
  static const double largest = compressedDistance(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1}));
  const double error = compressedDistance(a, b), bend = kShare * largest;
  return error < bend ? kTaken / bend * error
                      : kTaken + (1 - kTaken) * std::min((error - bend) / (largest - bend), 1.0);
}

}  // namespace boxlight::flip
