// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_fit.h"

#include <cassert>
#include <cmath>

#include "bake/kernels/box_search.h"
#include "bake/kernels/box_weights.h"

namespace boxlight {
namespace {

constexpr size_t kNoBox = ~size_t(0);

}  // namespace

struct BoxFitter::Scratch {
  explicit Scratch(FitOptions o) : options(o), grid(o.gridSize), search(grid, o.gainExponent, o.seeds) {}

  void insertBoxes();
  void refine();
  void insert(const GridBox& box);
  void updateResidual(size_t except = kNoBox);
  std::vector<Box> result(uint64_t pathCount) const;

  FitOptions options;
  DepositGrid grid;
  BoxSearch search;
  BoxWeights weights;
  GridSat data, residual;
  Lanes total;
  std::vector<GridBox> boxes;
  std::vector<Lanes> paint;
};

void BoxFitter::Scratch::insert(const GridBox& box) {
  boxes.push_back(box);
  weights.place(boxes.size() - 1, grid, boxes, data.sum(box));
  weights.solve(total);
}

void BoxFitter::Scratch::insertBoxes() {
  updateResidual();
  for (bool worthwhile = true; worthwhile && int(boxes.size()) < options.boxes;) {
    GridBox box;
    worthwhile = search.find(residual, box) > 0.0f;
    // When nothing stands out of the noise any more, one box around everything takes the rest.
    insert(worthwhile ? box : grid.bounds());
    updateResidual();
  }
}

void BoxFitter::Scratch::refine() {
  for (size_t i = 0; i < boxes.size(); ++i) {
    updateResidual(i);
    // A box that is not worth its noise would flee from the deposits; it stays.
    if (GridBox moved = boxes[i]; search.descend(residual, moved, 2) > 0.0f) boxes[i] = moved;
    weights.place(i, grid, boxes, data.sum(boxes[i]));
    weights.solve(total);
  }
}

/// The table of the residual T - sum_j w_j K_j. Boxes are painted by their corners, which sum up to the
/// weights per cell.
void BoxFitter::Scratch::updateResidual(size_t except) {
  const int columns = grid.columns(), rows = grid.rows();
  const size_t stride = size_t(columns) + 1;
  paint.assign(stride * (rows + 1), splat(0.0f));
  const auto paintRange = [&](int x0, int x1, const GridBox& b, Lanes w) {
    paint[b.y0 * stride + x0] += w;
    paint[b.y0 * stride + x1] -= w;
    paint[b.y1 * stride + x0] -= w;
    paint[b.y1 * stride + x1] += w;
  };
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (i == except) continue;
    const GridBox& b = boxes[i];
    paintRange(b.x0, std::min(b.x1, columns), b, weights.weight(i));
    if (b.x1 > columns) paintRange(0, b.x1 - columns, b, weights.weight(i));
  }
  Lanes weight = splat(0.0f);
  residual.build(columns, rows, [&](int x, int y) {
    Lanes& corner = paint[y * stride + x];
    if (y > 0) corner += paint[(y - 1) * stride + x];
    weight = x > 0 ? weight + corner : corner;
    return grid.cell(x, y) - grid.zone(y, y + 1) * grid.width(x, x + 1) * weight;
  });
}

std::vector<Box> BoxFitter::Scratch::result(uint64_t pathCount) const {
  std::vector<Box> result;
  dvec3 sum(0.0);
  for (size_t i = 0; i < boxes.size(); ++i) {
    Box box = grid.toBox(boxes[i]);
    const Lanes w = weights.weight(i);
    box.energy = grid.solidAngle(boxes[i]) * Rgb(w[0], w[1], w[2]);
    result.push_back(box);
    sum += dvec3(box.energy);
  }
  assert(!result.empty());
  const dvec3 mean = grid.total() / double(pathCount);
  for (int c = 0; c < 3; ++c) {
    // A channel too faint beside the others to have drawn a box of its own.
    if (!(sum[c] > 0.0)) result.front().energy[c] = float(sum[c] = 1.0);
    for (Box& box : result) box.energy[c] = float(double(box.energy[c]) * (mean[c] / sum[c]));
  }
  std::erase_if(result, [](const Box& box) { return maxComponent(box.energy) <= 0.0f; });
  std::stable_sort(result.begin(), result.end(), [](const Box& a, const Box& b) {
    return a.energy.x + a.energy.y + a.energy.z > b.energy.x + b.energy.y + b.energy.z;
  });
  return result;
}

BoxFitter::BoxFitter(FitOptions options) : options_(options), scratch_(std::make_unique<Scratch>(options)) {
  assert(options.boxes >= 1 && options.boxes <= 64 && options.gridSize >= 2 && options.gridSize <= 64);
  assert(options.seeds >= 1 && options.seeds <= 16 && options.refinements >= 0 && options.noise >= 0.0f);
}

BoxFitter::~BoxFitter() = default;
BoxFitter::BoxFitter(BoxFitter&&) noexcept = default;
BoxFitter& BoxFitter::operator=(BoxFitter&&) noexcept = default;

std::vector<Box> BoxFitter::fit(std::span<const Deposit> deposits, uint64_t pathCount, int boxes) {
  assert(boxes >= 1 && boxes <= options_.boxes);
  Scratch& s = *scratch_;
  s.options.boxes = boxes;
  if (!s.grid.build(deposits, s.options.noise)) return {};
  assert(pathCount >= deposits.size());
  s.boxes.clear();
  s.weights.reset();
  s.data.build(s.grid.columns(), s.grid.rows(), [&](int x, int y) { return s.grid.cell(x, y); });
  s.total = s.data.sum({0, s.grid.columns(), 0, s.grid.rows()});
  s.total[3] = 0.0f;
  s.insertBoxes();
  for (int round = 0; round < s.options.refinements; ++round) s.refine();
  return s.result(pathCount);
}

}  // namespace boxlight
