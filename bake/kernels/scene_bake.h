// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/kernels/texel_bake.h"
#include "common/asset/asset.h"
#include "common/base/progress.h"

namespace boxlight {

/// An asset with all its pages in memory.
struct BakedScene {
  asset::Asset asset;
  std::vector<std::vector<PackedBox>> pages;  ///< [stream * tileCount + tile]
  double removed = 0;  ///< by PathLimits::throughput, as a part of the transport's luminance
};

/// About what a bake is going to cost, for the user to see before it starts; of kernels, how many there may
/// be.
struct BakeCost {
  uint64_t records = 0, kernels = 0, paths = 0;
  uint64_t pageBytes = 0, mapBytes = 0;  ///< of boxes and visibility maps, before compression
};
BakeCost estimateCost(const std::vector<RecordPlan>& records, const ViewSphere& sphere,
                      const KernelOptions& options);

/// Slots of the glossy kernels of a record's tile.
uint32_t glossySlotsOf(const std::vector<RecordPlan>& records, uint32_t record, const KernelOptions& options);

/// Bakes all records on all threads of the current TBB arena and packs them into tiles. The result does not
/// depend on the threads. Throws Error(interrupted) after Ctrl-C.
BakedScene bakeScene(const Intersector& world, const TexelMap& map, const std::vector<RecordPlan>& records,
                     const ViewSphere& sphere, const KernelOptions& options, ProgressStyle progress);

}  // namespace boxlight
