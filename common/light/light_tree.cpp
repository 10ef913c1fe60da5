// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace boxlight {
namespace {

constexpr uint32_t kRootRows = 16, kRootsAround = 16;

/// Roots between two parallels of latitude.
struct Band {
  uint32_t row, first, widening;
};

Band bandOf(uint32_t root) {
  if (root < 4) return {0, 0, 4};
  if (root < 12) return {1, 4, 2};
  if (root >= kTreeRoots - 4) return {7, kTreeRoots - 4, 4};
  if (root >= kTreeRoots - 12) return {6, kTreeRoots - 12, 2};
  const uint32_t row = (root - 12) / kRootsAround;
  return {2 + row, 12 + row * kRootsAround, 1};
}

/// Every second bit of four.
uint32_t evenBits(uint32_t i) { return (i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8); }

/// Calls for every cell of a level.
template <class Visit>
void forLevel(uint32_t level, Visit&& visit) {
  for (uint32_t root = 0; root < kTreeRoots; ++root)
    for (TreeCell cell{root, level}; !cell.isEnd(); cell.leaf += 1u << 2 * level) visit(cell);
}

std::vector<dvec3> makeMomentsOfOne() {
  std::vector<dvec3> moments(kTreeCells);
  for (uint32_t level = 0; level < kTreeLevels; ++level)
    forLevel(level, [&](const TreeCell& cell) { moments[cell.place()] = momentOfOne(cell.texels()); });
  return moments;
}

}  // namespace

void TreeCell::pass() {
  leaf += 1u << 2 * level;
  level = std::min(kTreeLevels - 1, uint32_t(std::countr_zero(leaf)) / 2);
}

uint32_t TreeCell::place() const {
  const uint32_t depth = kTreeLevels - 1 - level;
  return kTreeRoots * (((1u << 2 * depth) - 1) / 3) + (root << 2 * depth) + (leaf >> 2 * level);
}

TreeCell::Texels TreeCell::texels() const {
  const auto [row, first, widening] = bandOf(root);
  const uvec2 inside(evenBits(leaf), evenBits(leaf >> 1));
  return {{widening * (kRootRows * (root - first) + inside.x), kRootRows * row + inside.y},
          {widening * rows(), rows()}};
}

Rectangle rectangleOf(TreeCell::Texels texels, double uOffset) {
  const dvec2 at = dvec2(texels.at) / dvec2(kMomentSize), size = dvec2(texels.size) / dvec2(kMomentSize);
  return {at.x - uOffset - std::floor(at.x - uOffset), at.y, size.x, size.y};
}

LightTree::LightTree(const std::function<dmat3(uint32_t x, uint32_t y)>& moment)
    : light_(kTreeCells, dmat3(0.0)) {
  forLevel(0, [&](const TreeCell& cell) {
    const auto [at, size] = cell.texels();
    for (uint32_t x = at.x; x < at.x + size.x; ++x) light_[cell.place()] += moment(x, at.y);
  });
  for (uint32_t level = 1; level < kTreeLevels; ++level)
    forLevel(level, [&](const TreeCell& cell) {
      TreeCell child = cell;
      child.enter();
      for (uint32_t k = 0; k < 4; ++k, child.leaf += 1u << 2 * child.level)
        light_[cell.place()] += light_[child.place()];
    });
}

LightCell LightTree::cell(const TreeCell& at) const {
  return {light_[at.place()], momentsOfOne()[at.place()]};
}

dvec3 momentOfOne(TreeCell::Texels texels) {
  const Rectangle r = rectangleOf(texels, 0.0);
  return r.solidAngle() * meanDirection(r.u0, r.v0, r.du, r.dv);
}

const std::vector<dvec3>& momentsOfOne() {
  static const std::vector<dvec3> moments = makeMomentsOfOne();
  return moments;
}

}  // namespace boxlight
