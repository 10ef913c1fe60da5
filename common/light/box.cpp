// SPDX-License-Identifier: Apache-2.0
#include "common/light/box.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr float kSteps = 65536.0f;

int roundToStep(float value) { return int(std::lround(double(value) * kSteps)); }

constexpr float kLargestHalf = 65504.0f;
constexpr float kLargestEnergy = 65408.0f;  ///< of half floats with nine significant bits

/// The nearest half float with nine significant bits, .2 % away at most: what lies beyond is the paths'
/// noise, which no page compresses.
uint16_t packEnergy(float energy) {
  constexpr uint32_t kDropped = 15;
  if (std::isnan(energy)) return glm::packHalf1x16(energy);
  uint32_t bits = std::bit_cast<uint32_t>(std::min(energy, kLargestEnergy));
  bits += (1u << (kDropped - 1)) - 1 + (bits >> kDropped & 1);  // ties to even
  return glm::packHalf1x16(std::bit_cast<float>(bits >> kDropped << kDropped));
}

}  // namespace

double Box::solidAngle() const { return rectangleSolidAngle(du, v0, double(v0) + double(dv)); }

Rgb Box::weight() const {
  const double omega = solidAngle();
  return omega > 0.0 ? Rgb(dvec3(energy) / omega) : Rgb(0.0f);
}

PackedBox packBox(const Box& box) {
  const int u0 = roundToStep(box.u0), v0 = std::clamp(roundToStep(box.v0), 0, 65535);
  const int u1 = roundToStep(box.u0 + box.du), v1 = std::clamp(roundToStep(box.v0 + box.dv), v0 + 1, 65536);
  PackedBox packed;
  packed.u0 = uint16_t(u0 & 65535);
  packed.v0 = uint16_t(v0);
  packed.du = uint16_t(std::clamp(u1 - u0, 1, 65536) - 1);
  packed.dv = uint16_t(v1 - v0 - 1);
  for (int c = 0; c < 3; ++c) packed.energy[c] = packEnergy(box.energy[c]);
  return packed;
}

Box unpackBox(const PackedBox& packed) {
  Box box;
  box.u0 = float(packed.u0) / kSteps;
  box.v0 = float(packed.v0) / kSteps;
  box.du = float(packed.du + 1) / kSteps;
  box.dv = std::min(float(packed.dv + 1) / kSteps, 1.0f - box.v0);
  for (int c = 0; c < 3; ++c) box.energy[c] = glm::unpackHalf1x16(packed.energy[c]);
  return box;
}

PackedBox packEmission(Rgb radiance) {
  int exponent = 0;
  const float largest = maxComponent(radiance);
  if (largest > 0.0f) std::frexp(largest, &exponent);
  PackedBox packed;
  packed.kind = kEmittedRadiance;
  packed.du = uint16_t(32768 + exponent);
  for (int c = 0; c < 3; ++c) packed.energy[c] = glm::packHalf1x16(std::ldexp(radiance[c], -exponent));
  return packed;
}

Rgb unpackEmission(const PackedBox& packed) {
  Rgb radiance(0.0f);
  for (int c = 0; c < 3; ++c)
    radiance[c] = std::ldexp(glm::unpackHalf1x16(packed.energy[c]), int(packed.du) - 32768);
  return radiance;
}

PackedBox packHiddenPart(float part) {
  PackedBox packed;
  packed.kind = kHiddenPart;
  packed.energy[0] = glm::packHalf1x16(part);
  return packed;
}

PackedBox packCosineBox(const CosineBox& box) {
  PackedBox packed = packBox(box.box);
  std::fill_n(packed.energy, 3, glm::packHalf1x16(std::clamp(box.amplitude, -kLargestHalf, kLargestHalf)));
  packed.kind = kCosineBox;
  return packed;
}

CosineBox unpackCosineBox(const PackedBox& packed) {
  const Box box = unpackBox(packed);
  return {box, box.energy.x};
}

float unpackHiddenPart(const PackedBox& packed) { return glm::unpackHalf1x16(packed.energy[0]); }

}  // namespace boxlight
