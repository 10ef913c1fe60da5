// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_fit.h"

#include <Eigen/Dense>
#include <cassert>
#include <glm/gtc/packing.hpp>

#include "bake/kernels/visibility_cells.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr double kLeastSamples = 2;  // that a box must explain
constexpr double kLeastEnergy = 1e-6;

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
  void solve(bool exact);
  std::vector<CosineBox> result() const;

  vec3 normal;
  VisibilityCells cells;
  std::vector<GridBox> boxes;
  std::vector<double> amplitudes;
  double open = 0;  // amplitude of the whole sphere
};

void VisibilityFitter::Fit::insertBoxes(const Options& options) {
  open = cells.straightPart() > 0.5 ? 1 : 0;
  const double least = std::max(options.worthwhile * cells.worth(), kLeastSamples);
  for (int count = 1; count < options.boxes; ++count) {
    cells.setResidual(open, boxes, amplitudes);
    GridBox box;
    if (cells.find(box) < least) break;
    boxes.push_back(box);
    solve(false);
  }
}

void VisibilityFitter::Fit::refine() {
  for (size_t i = 0; i < boxes.size(); ++i) {
    amplitudes[i] = 0;
    cells.setResidual(open, boxes, amplitudes);
    cells.descend(boxes[i], 2);
    solve(false);
  }
}

/// Least squares; `exact` under the condition that a constant light returns what the paths did.
void VisibilityFitter::Fit::solve(bool exact) {
  const auto count = Eigen::Index(boxes.size());
  if (count == 0) return;
  Eigen::MatrixXd gram(count, count);
  Eigen::VectorXd data(count), energy(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    data[i] = cells.data(boxes[size_t(i)], open);
    energy[i] = energyOf(cells.toBox(boxes[size_t(i)]), normal);
    for (Eigen::Index j = 0; j < count; ++j) gram(i, j) = cells.overlap(boxes[size_t(i)], boxes[size_t(j)]);
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(gram);
  Eigen::VectorXd solution = solver.solve(data);
  const Eigen::VectorXd shift = solver.solve(energy);
  const double response = energy.dot(shift);
  if (exact && response * cells.worth() > kLeastEnergy)
    solution += (cells.straightPart() - open - energy.dot(solution)) / response * shift;
  amplitudes.assign(solution.begin(), solution.end());
}

/// The whole sphere, if it is there, makes up for the rounding of the others.
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
  assert(options_.boxes >= 1 && options_.boxes <= 40);
  if (std::none_of(first.begin(), first.end(), [](const FirstDirection& d) { return d.straight; })) return {};
  Fit fit(first, normal);
  fit.insertBoxes(options_);
  for (int round = 0; round < options_.refinements; ++round) fit.refine();
  fit.solve(true);
  return fit.result();
}

}  // namespace boxlight
