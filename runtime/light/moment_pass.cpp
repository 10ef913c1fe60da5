// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/moment_pass.h"

#include <bit>
#include <cmath>
#include <span>

#include "common/light/bright_texels.h"
#include "common/light/light_tree.h"
#include "shaders/shared.h"
#include "spirv/bright_texels_comp.h"
#include "spirv/light_tree_comp.h"
#include "spirv/moment_cells_comp.h"
#include "spirv/moment_columns_comp.h"
#include "spirv/moment_nodes_comp.h"
#include "spirv/moment_rows_comp.h"
#include "spirv/moments_comp.h"

namespace boxlight::gpu {
namespace {

static_assert(kMomentColumns == kMomentSize.x && kMomentRows == kMomentSize.y);
static_assert(kHorizonColumns == kHorizonNodes.x && kHorizonRows == kHorizonNodes.y);
static_assert(kHorizonCellColumns == kHorizonCells.x && kHorizonCellRows == kHorizonCells.y);
static_assert(gpu::kBrightTexels == boxlight::kBrightTexels);
static_assert(gpu::kTreeRoots == boxlight::kTreeRoots && gpu::kTreeLevels == boxlight::kTreeLevels);
static_assert(gpu::kTreeLeaves == boxlight::kTreeLeaves && gpu::kTreeCells == boxlight::kTreeCells);

constexpr int kTotalBits = 30;     // a sum of either sign, and as much again
constexpr double kMargin = 1.001;  // of sums rounded to floats
constexpr double kSmallestUnit = 0x1p-100;

uint32_t groupsFor(uint32_t threads) { return (threads + kGroupSize - 1) / kGroupSize; }

std::vector<MomentCover::Texel> coversOf(const MomentCover& cover) {
  std::vector<MomentCover::Texel> covers = cover.columns;
  covers.insert(covers.end(), cover.rows.begin(), cover.rows.end());
  return covers;
}

std::vector<float> weightsOf(const MomentCover& cover) {
  std::vector<float> weights;
  for (const vec3& column : cover.columnWeights)
    weights.insert(weights.end(), {column.x, column.y, column.z});
  for (const vec2& row : cover.rowWeights) weights.insert(weights.end(), {row.x, row.y});
  return weights;
}

/// Moments of a light of 1, as each cell's w.
void addCell(std::vector<vec4>& cells, dvec3 one) {
  for (int axis = 0; axis < 3; ++axis) cells.emplace_back(0, 0, 0, float(one[axis]));
}

std::vector<vec4> makeHorizonCells() {
  std::vector<vec4> cells;
  constexpr uvec2 kSize = kMomentSize / kHorizonCells;
  for (uint32_t i = 0; i < kHorizonCellCount; ++i) {
    const uvec2 at = uvec2(i % kHorizonCellColumns, i / kHorizonCellColumns) * kSize;
    addCell(cells, momentOfOne({at, kSize}));
  }
  return cells;
}

std::vector<vec4> makeTreeCells() {
  std::vector<vec4> cells;
  for (const dvec3 one : momentsOfOne()) addCell(cells, one);
  return cells;
}

/// The normals of the nodes, as their w.
std::vector<uvec4> makeNodes() {
  std::vector<uvec4> nodes;
  for (uint32_t i = 0; i < kHorizonNodeCount; ++i) {
    const vec3 normal = uvToDirection({float(i % kHorizonColumns) / float(kHorizonColumns),
                                       float(i / kHorizonColumns) / float(kHorizonRows - 1)});
    for (int axis = 0; axis < 3; ++axis) nodes.emplace_back(0, 0, 0, std::bit_cast<uint32_t>(normal[axis]));
  }
  return nodes;
}

}  // namespace

MomentPass::MomentPass(Device& device, Bindings& bindings, uvec2 mapSize, bool trees)
    : mapSize_(mapSize),
      constants_(device, "constants of the moments", sizeof(MomentConstants)),
      covers_(device, "covers of the moments", 0),
      weights_(device, "weights of the moments", 0),
      texels_(device, "texels of the moments", 10 * kMomentColumns * kMomentRows * sizeof(float)),
      cells_(makeBuffer(device, "cells of the moments", makeHorizonCells())),
      moments_(device, bindings, moments_comp),
      rows_(device, bindings, moment_rows_comp),
      columns_(device, bindings, moment_columns_comp),
      brightTexels_(device, bindings, bright_texels_comp),
      cellSums_(device, bindings, moment_cells_comp),
      nodes_(device, bindings, moment_nodes_comp) {
  if (trees) trees_.emplace(device, bindings, light_tree_comp);
  const MomentCover cover = makeMomentCover(mapSize);
  rowShares_ = uint32_t(3 * cover.columnWeights.size());
  covers_ = makeBuffer(device, "covers of the moments", coversOf(cover));
  weights_ = makeBuffer(device, "weights of the moments", weightsOf(cover));
  const std::vector<uvec4> nodes = makeNodes();
  const std::vector<vec4> cells = trees ? makeTreeCells() : std::vector<vec4>{};
  for (int i = 0; i < 2; ++i) {
    tables_.emplace_back(device, "moments of the light", (trees ? kMomentEnd : kMomentTree) * sizeof(uvec4));
    upload(device, tables_.back(), std::as_bytes(std::span(nodes)), kMomentNodes * sizeof(uvec4));
    if (trees) upload(device, tables_.back(), std::as_bytes(std::span(cells)), kMomentTree * sizeof(uvec4));
  }
  bindings.set(gpu::kMomentConstants, constants_);
  bindings.set(gpu::kMomentCovers, covers_);
  bindings.set(gpu::kMomentWeights, weights_);
  bindings.set(gpu::kMomentTexels, texels_);
  bindings.set(gpu::kMomentCells, cells_);
}

void MomentPass::setTotal(Device& device, Bindings& bindings, double total, double margin) {
  nextUnit_ = float(std::max(std::ldexp(total * margin * kMargin, -kTotalBits), kSmallestUnit));
  const double least = kLeastBright * total / double(nextUnit_);
  MomentConstants constants{};
  constants.mapSize = mapSize_;
  constants.perUnit = 1.0f / nextUnit_;
  constants.rowShares = rowShares_;
  constants.leastSquare = std::max(float(least * least), 1.0f);
  upload(device, constants_, std::as_bytes(std::span(&constants, 1)));
  bindings.set(gpu::kMomentTable, tables_[1 - shown_]);
}

void MomentPass::build(Commands& commands) const {
  commands.dispatch(moments_, {kMomentColumns / kPixelGroup, kMomentRows / kPixelGroup, 1});
  commands.dispatch(rows_, {groupsFor(3 * kMomentRows), 1, 1});
  commands.dispatch(columns_, {groupsFor(3 * kMomentStride), 1, 1});
  commands.dispatch(brightTexels_, {1, 1, 1});
  commands.dispatch(cellSums_, {groupsFor(3 * kHorizonCellCount), 1, 1});
  commands.dispatch(nodes_, {groupsFor(kHorizonNodeCount), 1, 1});
  if (trees_) commands.dispatch(*trees_, {kTreeRoots, 1, 1});
}

void MomentPass::flip() {
  shown_ = 1 - shown_;
  unit_ = nextUnit_;
}

}  // namespace boxlight::gpu
