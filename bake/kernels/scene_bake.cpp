// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/scene_bake.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace boxlight {
namespace {

void copyScene(const Scene& scene, asset::Asset& target) {
  target.vertices = scene.vertices;
  target.triangles = scene.triangles;
  target.materials = scene.materials;
  target.textures = scene.textures;
  target.texels = scene.texels;
  for (int c = 0; c < 3; ++c) {
    target.info.boundsMin[c] = scene.boundsMin[c];
    target.info.boundsMax[c] = scene.boundsMax[c];
  }
}

std::vector<asset::Tile> makeTiles(const std::vector<RecordPlan>& records, const KernelOptions& options) {
  std::vector<asset::Tile> tiles;
  for (uint32_t first = 0; first < records.size(); first += asset::kTileRecords) {
    const uint32_t count = std::min(asset::kTileRecords, uint32_t(records.size()) - first);
    asset::Tile tile{first, count, 0, 0};
    for (uint32_t r = first; r < first + count; ++r) {
      if (records[r].glossy) tile.glossyBoxes = options.boxes;
      if (records[r].lambert) tile.diffuseBoxes = options.lambertBoxes();
    }
    tiles.push_back(tile);
  }
  return tiles;
}

/// Moves the kernels of one tile into its pages, record by record, and sets their bits.
void fillPages(BakedScene& baked, uint32_t tile, std::vector<RecordKernels>& kernels) {
  const asset::Tile& range = baked.asset.tiles[tile];
  const size_t tileCount = baked.asset.tiles.size();
  auto append = [&](uint32_t stream, uint32_t bit, std::vector<PackedBox>& boxes) {
    if (boxes.empty()) return;
    auto& page = baked.pages[stream * tileCount + tile];
    page.insert(page.end(), boxes.begin(), boxes.end());
    baked.asset.streamMasks[stream * tileCount + tile] |= uint64_t(1) << bit;
  };
  for (uint32_t r = 0; r < range.recordCount; ++r) {
    RecordKernels& record = kernels[range.firstRecord + r];
    for (uint32_t view = 0; view < record.glossy.size(); ++view) append(view, r, record.glossy[view]);
    append(baked.asset.diffuseStream(), r, record.lambert);
    record = {};
  }
}

}  // namespace

BakeCost estimateCost(const std::vector<RecordPlan>& records, const ViewSphere& sphere,
                      const KernelOptions& options) {
  BakeCost cost{.records = records.size()};
  for (const RecordPlan& plan : records) {
    const vec3 normal(plan.record.normal[0], plan.record.normal[1], plan.record.normal[2]);
    const auto views = viewsOfHemisphere(sphere, normal);
    const uint64_t glossy = plan.glossy ? uint64_t(std::count(views.begin(), views.end(), true)) : 0,
                   lambert = plan.lambert;
    cost.kernels += glossy + lambert;
    cost.paths += glossy * options.paths + lambert * options.lambertPaths();
    cost.pageBytes += (glossy * options.boxes + lambert * options.lambertBoxes()) * sizeof(PackedBox);
  }
  return cost;
}

BakedScene bakeScene(const Scene& scene, const Intersector& world, const TexelMap& map,
                     const std::vector<RecordPlan>& records, const ViewSphere& sphere,
                     const KernelOptions& options, ProgressStyle style) {
  BakedScene baked;
  asset::Asset& result = baked.asset;
  copyScene(scene, result);
  result.info.atlasWidth = map.width;
  result.info.atlasHeight = map.height;
  result.info.viewFrequency = sphere.frequency();
  result.info.viewCount = sphere.viewCount();
  result.atlas = indirection(map, records);
  for (const RecordPlan& plan : records) result.records.push_back(plan.record);
  result.tiles = makeTiles(records, options);
  result.streamMasks.assign(result.streamCount() * result.tiles.size(), 0);
  baked.pages.resize(result.streamMasks.size());

  std::vector<RecordKernels> kernels(records.size());
  tbb::enumerable_thread_specific<TexelBaker> bakers([&] { return TexelBaker(world, map, sphere, options); });
  Progress progress("bake", records.size(), style);
  tbb::parallel_for(size_t(0), result.tiles.size(), [&](size_t tile) {
    const asset::Tile& range = result.tiles[tile];
    for (uint32_t r = range.firstRecord; r < range.firstRecord + range.recordCount; ++r) {
      if (interrupted()) return;
      kernels[r] = bakers.local().bake(records[r]);
      progress.advance();
    }
    fillPages(baked, uint32_t(tile), kernels);
  });
  throwIfInterrupted("interrupted: no asset was written; run the same command again");
  return baked;
}

}  // namespace boxlight
