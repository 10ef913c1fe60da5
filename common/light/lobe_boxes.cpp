// SPDX-License-Identifier: Apache-2.0
#include "common/light/lobe_boxes.h"

#include <cmath>

#include "common/light/ggx.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kSamples = 3;  ///< each way in a cell
/// Times what midpoints of kSamples strata miss of a uniform distribution's spread.
const double kSpread = 1.1 / std::sqrt(1.0 - 1.0 / (kSamples * kSamples));
constexpr double kLeastSize = 1e-5;  ///< of a box, in the light domain

/// Of the random numbers: phi in turns, and the height on the cap.
struct Cell {
  float u, v, du, dv;
};

constexpr std::array<Cell, kLobeBoxes> makeCells() {
  constexpr float kRing[] = {0.0f, 0.15f, 0.55f, 0.9f, 1.0f};
  std::array<Cell, kLobeBoxes> cells{};
  cells[0] = {0, kRing[0], 1, kRing[1] - kRing[0]};
  for (int i = 0; i < 4; ++i) {
    cells[size_t(1 + i)] = {0.25f * float(i) + 0.125f, kRing[1], 0.25f, kRing[2] - kRing[1]};
    cells[size_t(5 + i)] = {0.25f * float(i), kRing[2], 0.25f, kRing[3] - kRing[2]};
  }
  cells[9] = {0, kRing[3], 1, kRing[4] - kRing[3]};
  return cells;
}

constexpr std::array<Cell, kLobeBoxes> kCells = makeCells();

/// Weighted moments of directions, phi as a vector in the plane.
struct Moments {
  double weight = 0, cosine = 0, sine = 0, theta = 0, thetaSquared = 0;
  dvec3 energy{0.0};

  void add(vec3 direction, Rgb value) {
    const auto w = double(luminance(value));
    energy += dvec3(value);
    const double ring = std::hypot(double(direction.x), double(direction.z));
    const double t = std::atan2(ring, double(direction.y));
    weight += w, theta += w * t, thetaSquared += w * t * t;
    if (!(ring > 0)) return;
    cosine += w * double(direction.x) / ring;
    sine += w * double(direction.z) / ring;
  }
};

/// d of sin(pi d) / (pi d) = length: x^2 = 6 q + 9/5 q^2 + c q^3 with q = 1 - length, c such that length 0 is
/// a full turn.
double arcOfMeanVector(double length) {
  const double q = 1 - std::min(length, 1.0);
  constexpr double kCubic = kPiDouble * kPiDouble - 7.8;
  return std::sqrt(q * (6 + q * (1.8 + q * kCubic))) / kPiDouble;
}

Box boxOf(const Moments& m) {
  Box box;
  if (!(m.weight > 0)) return {0, 0, 1, 1, Rgb(0.0f)};
  const double arc = arcOfMeanVector(std::hypot(m.cosine, m.sine) / m.weight);
  const double du = std::clamp(kSpread * arc, kLeastSize, 1.0);
  const double u = 0.5 + std::atan2(m.sine, m.cosine) / (2 * kPiDouble) - 0.5 * du;
  const double mean = m.theta / m.weight;
  const double deviation = std::sqrt(std::max(m.thetaSquared / m.weight - mean * mean, 0.0));
  const double half = std::max(0.5 * kSpread * std::sqrt(12.0) * deviation / kPiDouble, kLeastSize);
  const double v0 = std::max(mean / kPiDouble - half, 0.0), v1 = std::min(mean / kPiDouble + half, 1.0);
  box.u0 = float(u - std::floor(u));
  box.v0 = float(v0);
  box.du = float(du);
  box.dv = float(v1 - v0);
  return box;
}

Moments momentsOf(const GgxLobe& lobe, vec3 view, const Cell& cell) {
  Moments moments;
  const float masking = ggx::masking(view, lobe.alpha);
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const vec2 at((float(i % kSamples) + 0.5f) / kSamples, (float(i / kSamples) + 0.5f) / kSamples);
    const float turn = cell.u + cell.du * at.x;
    const vec3 half =
        ggx::sampleVisibleNormal(view, lobe.alpha, {turn - std::floor(turn), cell.v + cell.dv * at.y});
    const vec3 light = 2 * glm::dot(view, half) * half - view;
    if (!(light.z > 0)) continue;
    const float weight = ggx::visibility(light, view, lobe.alpha) * 4 * light.z * view.z / masking;
    const Rgb fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * ggx::schlickWeight(glm::dot(view, half));
    moments.add(light.x * lobe.tangent + light.y * lobe.bitangent + light.z * lobe.normal, weight * fresnel);
  }
  return moments;
}

}  // namespace

std::array<Box, kLobeBoxes> lobeBoxes(const GgxLobe& lobe) {
  const vec3 view(glm::dot(lobe.view, lobe.tangent), glm::dot(lobe.view, lobe.bitangent),
                  glm::dot(lobe.view, lobe.normal));
  std::array<Box, kLobeBoxes> boxes;
  std::array<dvec3, kLobeBoxes> energy;
  dvec3 total(0.0);
  for (size_t j = 0; j < kLobeBoxes; ++j) {
    const Moments moments = momentsOf(lobe, view, kCells[j]);
    boxes[j] = boxOf(moments);
    total += energy[j] = moments.energy * double(kCells[j].du * kCells[j].dv);
  }
  total = glm::max(total, dvec3(1e-30));
  for (size_t j = 0; j < kLobeBoxes; ++j) boxes[j].energy = Rgb(energy[j] / total);
  return boxes;
}

}  // namespace boxlight
