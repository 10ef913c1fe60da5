// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/normal_set.h"

#include <array>
#include <cmath>
#include <vector>

#include "bake/scene/mesh.h"

namespace boxlight {
namespace {

constexpr int kSteps = 48;

/// The octahedral map: Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors",
/// JCGT 3(2), 2014.
dvec3 octahedralDirection(double x, double y) {
  dvec3 d(x, y, 1 - std::abs(x) - std::abs(y));
  if (d.z < 0) {
    d.x = (1 - std::abs(y)) * (x < 0 ? -1.0 : 1.0);
    d.y = (1 - std::abs(x)) * (y < 0 ? -1.0 : 1.0);
  }
  return glm::normalize(d);
}

template <int kSide>
const std::array<dvec3, size_t(kSide) * kSide>& cellCentres() {
  static const auto centres = [] {
    std::array<dvec3, size_t(kSide) * kSide> table;
    for (int i = 0; i < kSide * kSide; ++i)
      table[size_t(i)] = octahedralDirection((2 * (i % kSide) + 1) / double(kSide) - 1,
                                             (2 * (i / kSide) + 1) / double(kSide) - 1);
    return table;
  }();
  return centres;
}

}  // namespace

void NormalSet::add(dvec3 d) {
  d /= std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  double x = d.x, y = d.y;
  if (d.z < 0) {
    x = (1 - std::abs(d.y)) * (d.x < 0 ? -1.0 : 1.0);
    y = (1 - std::abs(d.x)) * (d.y < 0 ? -1.0 : 1.0);
  }
  const auto cell = [](double c) { return std::clamp(int((c + 1) * 0.5 * kSide), 0, kSide - 1); };
  cells_.set(size_t(cell(y)) * kSide + size_t(cell(x)));
}

void NormalSet::add(const NormalSet& other) { cells_ |= other.cells_; }

NormalSet::Cone NormalSet::cone(dvec3 mean, double wanted) const {
  std::vector<dvec3> directions;
  for (size_t i = cells_._Find_first(); i < cells_.size(); i = cells_._Find_next(i))
    directions.push_back(cellCentres<kSide>()[i]);
  Cone best{glm::dot(mean, mean) > 0 ? glm::normalize(mean) : directions[0], -1};
  dvec3 axis = best.axis;
  for (int step = 1; step <= kSteps && best.cosine < wanted; ++step) {
    double cosine = 2;
    dvec3 farthest(0);
    for (const dvec3& d : directions)
      if (glm::dot(d, axis) < cosine) cosine = glm::dot(d, axis), farthest = d;
    if (cosine > best.cosine) best = {axis, cosine};
    const dvec3 next = axis + (farthest - axis) / double(step + 1);
    if (glm::dot(next, next) < 1e-12) break;
    axis = glm::normalize(next);
  }
  return best;
}

}  // namespace boxlight
