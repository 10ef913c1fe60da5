// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/scene_bake.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cassert>

namespace boxlight {
namespace {

void copyScene(const Scene& scene, asset::Asset& target) {
  target.vertices = scene.vertices;
  target.triangles = scene.triangles;
  target.materials = scene.materials;
  target.materialExtensions = scene.materialExtensions;
  target.textureTransforms = scene.textureTransforms;
  target.textures = scene.textures;
  target.texels = scene.texels;
  for (int c = 0; c < 3; ++c) {
    target.info.boundsMin[c] = scene.boundsMin[c];
    target.info.boundsMax[c] = scene.boundsMax[c];
  }
}

std::span<const RecordPlan> recordsOf(const asset::Tile& tile, const std::vector<RecordPlan>& records) {
  return std::span(records).subspan(tile.firstRecord, tile.recordCount);
}

/// All glossy kernels of a tile have the slots that its most demanding record asks for.
uint32_t glossySlots(std::span<const RecordPlan> records, const KernelOptions& options) {
  uint32_t slots = 0;
  for (const RecordPlan& plan : records)
    if (plan.glossy) slots = std::max(slots, options.glossySlots(plan));
  return slots;
}

/// Tiles hold records of one level: none is read for a picture that is far from it.
uint32_t tileLength(const std::vector<RecordPlan>& records, uint32_t first) {
  uint32_t count = 1;
  while (count < asset::kTileRecords && first + count < records.size() &&
         records[first + count].record.level == records[first].record.level)
    ++count;
  return count;
}

std::vector<asset::Tile> makeTiles(const std::vector<RecordPlan>& records, const KernelOptions& options) {
  std::vector<asset::Tile> tiles;
  for (uint32_t first = 0; first < records.size(); first += tiles.back().recordCount) {
    const uint32_t count = tileLength(records, first);
    asset::Tile tile{first, count, 0, 0};
    const auto own = recordsOf(tile, records);
    tile.glossyBoxes = glossySlots(own, options);
    if (std::any_of(own.begin(), own.end(), [](const RecordPlan& plan) { return plan.lambert; }))
      tile.diffuseBoxes = options.lambertBoxes();
    tiles.push_back(tile);
  }
  return tiles;
}

bool isLit(const RecordKernel& kernel) { return maxComponent(kernel.emission) > 0.0f; }

/// Moves the kernels of one tile into its pages, record by record, and sets their bits. Where an emitter
/// reaches any of them, all get a slot for it.
void fillPages(BakedScene& baked, uint32_t tile, std::span<RecordKernels> kernels) {
  asset::Tile& range = baked.asset.tiles[tile];
  const size_t tileCount = baked.asset.tiles.size();
  bool lambertLit = false, glossyLit = false;
  for (const RecordKernels& record : kernels) {
    lambertLit |= isLit(record.lambert);
    glossyLit |= std::any_of(record.glossy.begin(), record.glossy.end(), isLit) ||
                 std::any_of(record.cells.begin(), record.cells.end(), isLit);
  }
  range.diffuseBoxes += lambertLit;
  range.glossyBoxes += glossyLit;
  auto append = [&](uint32_t stream, uint32_t bit, const RecordKernel& kernel, bool lit) {
    if (kernel.slots.empty()) return;
    auto& page = baked.pages[stream * tileCount + tile];
    if (lit) page.push_back(packEmission(kernel.emission));
    page.insert(page.end(), kernel.slots.begin(), kernel.slots.end());
    baked.asset.streamMasks[stream * tileCount + tile] |= uint64_t(1) << bit;
  };
  for (uint32_t r = 0; r < kernels.size(); ++r) {
    const auto& glossy = kernels[r].glossy;
    for (uint32_t view = 0; view < glossy.size(); ++view) append(view, r, glossy[view], glossyLit);
    for (uint32_t cell = 0; cell < kernels[r].cells.size(); ++cell)
      append(baked.asset.firstCellStream() + cell, r, kernels[r].cells[cell], glossyLit);
    append(baked.asset.diffuseStream(), r, kernels[r].lambert, lambertLit);
  }
}

/// What records and then tiles add up to, in their order: the same whatever the threads.
struct TileResult {
  double energy = 0, removed = 0;
  std::vector<VisibilityMap> maps;

  void add(const RecordKernels& record) {
    energy += record.energy + record.removed, removed += record.removed;
    if (record.visibility) maps.push_back(*record.visibility);
  }
  void add(const TileResult& tile) {
    energy += tile.energy, removed += tile.removed;
    maps.insert(maps.end(), tile.maps.begin(), tile.maps.end());
  }
};

asset::Scheme schemeOf(const std::vector<RecordPlan>& records) {
  const auto any = [&](bool (RecordPlan::*has)() const) {
    return std::any_of(records.begin(), records.end(), [=](const RecordPlan& plan) { return (plan.*has)(); });
  };
  if (any(&RecordPlan::hasCells)) return asset::Scheme::cells;
  return any(&RecordPlan::isSplit) ? asset::Scheme::split : asset::Scheme::sketch;
}

asset::GeodesicSphere sphereOf(uint32_t frequency) { return {frequency, ViewSphere(frequency).viewCount()}; }

}  // namespace

uint32_t glossySlotsOf(const std::vector<RecordPlan>& records, uint32_t record,
                       const KernelOptions& options) {
  for (const asset::Tile& tile : makeTiles(records, options))
    if (record - tile.firstRecord < tile.recordCount) return tile.glossyBoxes;
  return 0;
}

BakeCost estimateCost(const std::vector<RecordPlan>& records, const ViewSphere& sphere,
                      const KernelOptions& options) {
  const ViewSphere cells(options.cellFrequency);
  const std::vector<ViewSphere> spheres = viewSpheres(sphere);
  BakeCost cost{.records = records.size()};
  for (const RecordPlan& plan : records) {
    const vec3 normal(plan.record.normal[0], plan.record.normal[1], plan.record.normal[2]);
    const auto directions = viewsOfHemisphere(plan.hasCells() ? cells : spheres[plan.viewSphere()], normal);
    const uint64_t glossy =
                       plan.glossy ? uint64_t(std::count(directions.begin(), directions.end(), true)) : 0,
                   lambert = plan.lambert;
    cost.kernels += glossy + lambert;
    cost.paths += glossy * options.glossyPaths(plan.glossyLobes) + lambert * options.lambertPaths();
    cost.pageBytes +=
        (glossy * options.glossySlots(plan) + lambert * options.lambertBoxes()) * sizeof(PackedBox);
    if (plan.isSplit()) cost.mapBytes += sizeof(VisibilityMap), cost.paths += VisibilityMap::kCells;
  }
  return cost;
}

BakedScene bakeScene(const Intersector& world, const TexelMap& map, const std::vector<RecordPlan>& records,
                     const ViewSphere& sphere, const KernelOptions& options, ProgressStyle style) {
  BakedScene baked;
  asset::Asset& result = baked.asset;
  copyScene(world.scene(), result);
  result.info.atlasWidth = map.width;
  result.info.atlasHeight = map.height;
  result.info.viewFrequency = sphere.frequency();
  result.info.viewCount = sphere.viewCount();
  result.atlas = indirection(map, 0, records);
  for (uint32_t level = 1; level <= map.coarser.size(); ++level) {
    const std::vector<asset::AtlasTexel> texels = indirection(map, level, records);
    result.atlasLevels.insert(result.atlasLevels.end(), texels.begin(), texels.end());
  }
  for (const RecordPlan& plan : records) result.records.push_back(plan.record);
  result.tiles = makeTiles(records, options);
  result.scheme = schemeOf(records);
  if (result.scheme == asset::Scheme::cells) result.cellSphere = {sphereOf(options.cellFrequency)};
  uint32_t coarsest = 0;
  for (const RecordPlan& plan : records) coarsest = std::max(coarsest, plan.viewSphere());
  assert(coarsest == 0 || kViewsByRoughness[0].frequency < sphere.frequency());
  for (uint32_t s = 0; s < coarsest; ++s)
    result.coarseViews.push_back(sphereOf(kViewsByRoughness[s].frequency));
  result.streamMasks.assign(result.streamCount() * result.tiles.size(), 0);
  baked.pages.resize(result.streamMasks.size());
  std::vector<TileResult> tiles(result.tiles.size());
  tbb::enumerable_thread_specific<TexelBaker> bakers([&] { return TexelBaker(world, map, sphere, options); });
  Progress progress("bake", records.size(), style);
  tbb::parallel_for(size_t(0), result.tiles.size(), [&](size_t tile) {
    const auto own = recordsOf(result.tiles[tile], records);
    const uint32_t slots = result.tiles[tile].glossyBoxes;
    std::vector<RecordKernels> kernels;
    for (const RecordPlan& plan : own) {
      if (interrupted()) return;
      kernels.push_back(bakers.local().bake(plan, slots));
      tiles[tile].add(kernels.back());
      progress.advance();
    }
    fillPages(baked, uint32_t(tile), kernels);
  });
  throwIfInterrupted("interrupted: no asset was written; run the same command again");
  TileResult total;
  for (const TileResult& tile : tiles) total.add(tile);
  result.visibilityMaps = std::move(total.maps);
  baked.removed = total.energy > 0.0 ? total.removed / total.energy : 0.0;
  return baked;
}

}  // namespace boxlight
