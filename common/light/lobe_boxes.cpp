// SPDX-License-Identifier: Apache-2.0
#include "common/light/lobe_boxes.h"

#include <cmath>

#include "common/light/ggx.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr float kOverlap = 1.1f;     ///< of boxes
constexpr double kLeastSize = 1e-5;  ///< of a box, in the light domain

/// x: phi in turns; y: the height on the cap, so that equal areas have equal probability. The midpoints of
/// n strata miss 1 / n^2 of a uniform distribution's variance.
LobeCell makeSector(vec2 corner, vec2 size) {
  LobeCell cell{{}, size.x * size.y, kOverlap / std::sqrt(1.0f - 0.25f)};
  for (int i = 0; i < 4; ++i) {
    const vec2 random = corner + size * (vec2(i % 2, i / 2) + 0.5f) * 0.5f;
    cell.random[size_t(i)] = {random.x - std::floor(random.x), random.y};
  }
  return cell;
}

/// Four directions at the mean square distance from the axis have the spread of all.
LobeCell makeRing(float from, float to) {
  LobeCell cell{{}, to - from, kOverlap};
  for (int i = 0; i < 4; ++i) cell.random[size_t(i)] = {0.25f * (float(i) + 0.5f), 0.5f * (from + to)};
  return cell;
}

LobeCells makeRoundCells() {
  constexpr float kRadii[] = {0.0f, 0.08f, 0.28f, 0.52f, 0.76f, 0.93f, 1.0f};
  LobeCells cells;
  cells.front() = makeRing(kRadii[0], kRadii[1]);
  for (size_t ring = 0; ring < 4; ++ring)
    for (size_t i = 0; i < 4; ++i)
      cells[1 + 4 * ring + i] = makeSector({0.25f * float(i) + (ring % 2 ? 0.0f : 0.125f), kRadii[ring + 1]},
                                           {0.25f, kRadii[ring + 2] - kRadii[ring + 1]});
  cells.back() = makeRing(kRadii[5], kRadii[6]);
  return cells;
}

/// Random numbers of a slope, in units of alpha. At normal incidence slopes are distributed as
/// 1 / (pi (1 + x^2 + y^2)^2).
vec2 randomOfSlope(double x, double y) {
  const double turn = std::atan2(y, x) / (2 * kPiDouble), square = x * x + y * y;
  return {float(turn - std::floor(turn)), float(square / (1 + square))};
}

/// Strips of equal probability: x has the distribution function (1 + x / sqrt(1 + x^2)) / 2. At each x, y is
/// s sqrt((1 + x^2) / 3) with Student's t distribution of three degrees of freedom for s, whose standard
/// deviation is cut off by what a box is to hold.
LobeCells makeStripCells() {
  constexpr double kSpreadOfY = 0.9;
  LobeCells cells;
  for (size_t j = 0; j < kLobeBoxes; ++j) {
    cells[j].area = 1.0f / kLobeBoxes;
    cells[j].spread = kOverlap;
    for (int i = 0; i < 4; ++i) {
      const double part = (double(j) + 0.25 + 0.5 * (i % 2)) / kLobeBoxes, t = 2 * part - 1;
      const double x = t / std::sqrt(1 - t * t);
      cells[j].random[size_t(i)] =
          randomOfSlope(x, (i / 2 ? 1 : -1) * kSpreadOfY * std::sqrt((1 + x * x) / 3));
    }
  }
  return cells;
}

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

Box boxOf(const Moments& m, double spread) {
  Box box;
  if (!(m.weight > 0)) return {0, 0, 1, 1, Rgb(0.0f)};
  const double arc = arcOfMeanVector(std::hypot(m.cosine, m.sine) / m.weight);
  const double du = std::clamp(spread * arc, kLeastSize, 1.0);
  const double u = 0.5 + std::atan2(m.sine, m.cosine) / (2 * kPiDouble) - 0.5 * du;
  const double mean = m.theta / m.weight;
  const double deviation = std::sqrt(std::max(m.thetaSquared / m.weight - mean * mean, 0.0));
  const double half = std::max(0.5 * spread * std::sqrt(12.0) * deviation / kPiDouble, kLeastSize);
  const double v0 = std::max(mean / kPiDouble - half, 0.0), v1 = std::min(mean / kPiDouble + half, 1.0);
  box.u0 = float(u - std::floor(u));
  box.v0 = float(v0);
  box.du = float(du);
  box.dv = float(v1 - v0);
  return box;
}

vec3 localView(const GgxLobe& lobe) {
  return {glm::dot(lobe.view, lobe.tangent), glm::dot(lobe.view, lobe.bitangent),
          glm::dot(lobe.view, lobe.normal)};
}

struct Reflection {
  vec3 light{0.0f};   ///< local; 0 if it is below the horizon
  dvec3 energy{0.0};  ///< F G2 / G1
};

Reflection reflect(const GgxLobe& lobe, vec3 view, vec2 random) {
  const vec3 half = ggx::sampleVisibleNormal(view, lobe.alpha, random);
  const vec3 light = 2 * glm::dot(view, half) * half - view;
  if (!(light.z > 0)) return {};
  const float masking = ggx::masking(view, lobe.alpha);
  const float weight = ggx::visibility(light, view, lobe.alpha) * 4 * light.z * view.z / masking;
  Rgb fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * ggx::schlickWeight(glm::dot(view, half));
  if (lobe.filmed) fresnel = glm::clamp(fresnel, kLeastFilmed, 1.0f);
  return {light, dvec3(weight * fresnel)};
}

Moments momentsOf(const GgxLobe& lobe, vec3 view, const LobeCell& cell) {
  Moments moments;
  for (const vec2 random : cell.random) {
    const auto [light, energy] = reflect(lobe, view, random);
    if (!(light.z > 0)) continue;
    moments.add(light.x * lobe.tangent + light.y * lobe.bitangent + light.z * lobe.normal, Rgb(energy));
  }
  return moments;
}

}  // namespace

const LobeCells& roundCells() {
  static const LobeCells cells = makeRoundCells();
  return cells;
}

const LobeCells& stripCells() {
  static const LobeCells cells = makeStripCells();
  return cells;
}

/// A half vector that moves by t, orthogonal to the normal n, moves the reflection of the view v by
/// 2 (v.t) n + 2 (v.n) t: along w if t is w without its part along n.
vec3 lobeTangent(vec3 normal, vec3 view) {
  constexpr float kLeastTangent = 1e-4f;
  const vec3 mirror = 2 * glm::dot(view, normal) * normal - view;
  vec3 along(-mirror.z, 0, mirror.x);
  along -= glm::dot(along, normal) * normal;
  if (glm::length(along) > kLeastTangent) return glm::normalize(along);
  const vec3 any = std::abs(normal.x) < 0.6f ? vec3(1, 0, 0) : vec3(0, 1, 0);
  return glm::normalize(any - glm::dot(any, normal) * normal);
}

namespace {

/// The moments of all cells.
struct Lobe {
  explicit Lobe(const GgxLobe& lobe);
  dvec3 energy(size_t j) const { return of[j].energy * double(cells[j].area / kLobeSamples); }

  const LobeCells& cells;
  std::array<Moments, kLobeBoxes> of;
  dvec3 albedo{0.0};
};

Lobe::Lobe(const GgxLobe& lobe)
    : cells(lobe.alpha.x > kStripRatio * lobe.alpha.y ? stripCells() : roundCells()) {
  const vec3 view = localView(lobe);
  for (size_t j = 0; j < kLobeBoxes; ++j) {
    of[j] = momentsOf(lobe, view, cells[j]);
    albedo += energy(j);
  }
}

}  // namespace

std::array<Box, kLobeBoxes> lobeBoxes(const GgxLobe& lobe) {
  std::array<Box, kLobeBoxes> boxes;
  const Lobe moments(lobe);
  const dvec3 total = glm::max(moments.albedo, dvec3(1e-30));
  for (size_t j = 0; j < kLobeBoxes; ++j) {
    boxes[j] = boxOf(moments.of[j], double(moments.cells[j].spread));
    boxes[j].energy = Rgb(moments.energy(j) / total);
  }
  return boxes;
}

Rgb lobeAlbedo(const GgxLobe& lobe) {
  dvec3 sum(0.0);
  for (uint32_t i = 0; i < kAlbedoSamples; ++i) {
    const vec2 random((float(i * kAlbedoStep % kAlbedoSamples) + 0.5f) / kAlbedoSamples,
                      (float(i) + 0.5f) / kAlbedoSamples);
    sum += reflect(lobe, localView(lobe), random).energy;
  }
  return Rgb(sum / double(kAlbedoSamples));
}

}  // namespace boxlight
