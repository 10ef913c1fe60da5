// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_fit.h"

#include <cassert>
#include <glm/gtc/packing.hpp>

#include "bake/kernels/visibility_cells.h"
#include "bake/kernels/visibility_search.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// Of the samples: where more go straight, boxes take away from the whole sphere.
constexpr double kOpenPart = 0.8;
constexpr double kLeastSamples = 2;  // that a box must explain
constexpr int kSweeps = 60;
constexpr double kConverged = 1e-4;  // change of an amplitude in a sweep

/// What a box of amplitude 1 returns under a constant light of radiance 1.
double energyOf(const Box& box, vec3 normal) {
  const double cosine = glm::dot(dvec3(normal), meanDirection(box.u0, box.v0, box.du, box.dv));
  return std::max(box.solidAngle() * cosine / kPiDouble, 0.0);
}

}  // namespace

struct VisibilityFitter::Fit {
  Fit(std::span<const FirstDirection> first, vec3 n) : normal(n), cells(first, n) {}

  void insertBoxes(const Options& options);
  void refine();
  void updateResidual() { search.build(cells.residual(open, boxes, amplitudes), open > 0); }
  void solve();
  void scaleToPaths();
  std::vector<CosineBox> result() const;

  vec3 normal;
  VisibilityCells cells;
  VisibilitySearch search;
  std::vector<GridBox> boxes;
  std::vector<double> amplitudes;
  double open = 0;  // amplitude of the whole sphere
};

void VisibilityFitter::Fit::insertBoxes(const Options& options) {
  open = cells.straightPart() > kOpenPart ? 1 : 0;
  const double least = std::max(options.worthwhile * cells.worth(), kLeastSamples);
  for (int count = 1; count < options.boxes; ++count) {
    updateResidual();
    GridBox box;
    if (search.find(box) < least) break;
    boxes.push_back(box);
    solve();
  }
}

void VisibilityFitter::Fit::refine() {
  for (size_t i = 0; i < boxes.size(); ++i) {
    const GridBox before = boxes[i];
    const std::vector<double> kept = amplitudes;
    amplitudes[i] = 0;
    updateResidual();
    search.descend(boxes[i], 2);
    solve();
    // Where the others leaned on the box that moved away, it stays.
    if (open > 0 && !cells.isPaintBounded()) boxes[i] = before, amplitudes = kept;
  }
}

/// Least squares with amplitudes from 0, or of boxes that take away from the whole sphere: there their sum is
/// kept in [-1, 0] everywhere, for below it they would take from the sky what a hidden sun did not send.
void VisibilityFitter::Fit::solve() {
  const size_t count = boxes.size();
  amplitudes.resize(count, 0.0);
  std::vector<double> gram(count * count), gradient(count);
  for (size_t i = 0; i < count; ++i) {
    gradient[i] = cells.data(boxes[i], open);
    for (size_t j = 0; j < count; ++j) {
      gram[i * count + j] = cells.overlap(boxes[i], boxes[j]);
      gradient[i] -= gram[i * count + j] * amplitudes[j];
    }
  }
  cells.paint(boxes, amplitudes);
  double largest = 1;
  for (int sweep = 0; sweep < kSweeps && largest > kConverged; ++sweep) {
    largest = 0;
    for (size_t i = 0; i < count; ++i) {
      const double wanted = gradient[i] / gram[i * count + i];
      const double step = open > 0 ? cells.takeAway(boxes[i], wanted) : std::max(wanted, -amplitudes[i]);
      amplitudes[i] += step;
      largest = std::max(largest, std::abs(step));
      for (size_t j = 0; j < count; ++j) gradient[j] -= gram[i * count + j] * step;
    }
  }
}

/// Boxes that stand alone return under a constant light what the paths did.
void VisibilityFitter::Fit::scaleToPaths() {
  double energy = 0;
  for (size_t i = 0; i < boxes.size(); ++i) energy += amplitudes[i] * energyOf(cells.toBox(boxes[i]), normal);
  const double scale = cells.straightPart() / energy;
  if (scale > 0.5 && scale < 2.0)
    for (double& amplitude : amplitudes) amplitude *= scale;
}

/// The whole sphere, if it is there, makes up for what the others miss.
std::vector<CosineBox> VisibilityFitter::Fit::result() const {
  std::vector<CosineBox> result;
  double rest = cells.straightPart();
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Box box = cells.toBox(boxes[i]);
    result.push_back({box, glm::unpackHalf1x16(glm::packHalf1x16(float(amplitudes[i])))});
    rest -= double(result.back().amplitude) * energyOf(box, normal);
  }
  if (open > 0 || result.empty()) result.insert(result.begin(), {Box{0, 0, 1, 1}, float(rest)});
  return result;
}

std::vector<CosineBox> VisibilityFitter::fit(std::span<const FirstDirection> first, vec3 normal) {
  assert(options_.boxes >= 1 && options_.boxes <= 48);
  if (std::none_of(first.begin(), first.end(), [](const FirstDirection& d) { return d.straight; })) return {};
  Fit fit(first, normal);
  fit.insertBoxes(options_);
  for (int round = 0; round < options_.refinements; ++round) fit.refine();
  fit.solve();
  if (fit.open == 0) fit.scaleToPaths();
  return fit.result();
}

}  // namespace boxlight
