// SPDX-License-Identifier: Apache-2.0
#include "common/asset/asset_checks.h"

#include "common/asset/number_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

void checkInfo(const Info& info, const Reporter& report) {
  const auto size = [&](uint32_t value, uint32_t limit, const char* name) {
    if (value < 1 || value > limit)
      report(limits, chunk::kInfo, name, "{}, allowed are 1 to {}", value, limit);
  };
  size(info.atlasWidth, kMaxAtlasSize, "atlasWidth");
  size(info.atlasHeight, kMaxAtlasSize, "atlasHeight");
  size(info.viewFrequency, kMaxViewFrequency, "viewFrequency");
  if (const uint32_t f = info.viewFrequency; isFrequency(f) && info.viewCount != sphereVertices(f))
    report(viewCount, chunk::kInfo, "viewCount", "{} views at frequency {}, which has {}", info.viewCount, f,
           sphereVertices(f));
  if (!allFinite(info.boundsMin) || !allFinite(info.boundsMax))
    report(notFinite, chunk::kInfo, "bounds", "NaN or infinite");
}

}  // namespace

void checkTiles(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  uint64_t next = 0;
  for (size_t i = 0; i < asset.tiles.size(); ++i) {
    const Tile& tile = asset.tiles[i];
    const std::string place = fmt::format("tile {}", i);
    if (tile.firstRecord != next || tile.recordCount < 1 || tile.recordCount > kTileRecords)
      report(tileRange, chunk::kTiles, place, "{} records from {}, the one before ends at {}",
             tile.recordCount, tile.firstRecord, next);
    if (tile.glossyBoxes > kMaxBoxesPerKernel || tile.diffuseBoxes > kMaxBoxesPerKernel)
      report(tileBoxes, chunk::kTiles, place, "{} glossy and {} diffuse boxes per kernel, the limit is {}",
             tile.glossyBoxes, tile.diffuseBoxes, kMaxBoxesPerKernel);
    next = uint64_t(tile.firstRecord) + tile.recordCount;
  }
  if (present.has({chunk::kTiles, chunk::kRecords}) && next != asset.records.size())
    report(tileRange, chunk::kTiles, "", "the last tile ends at record {} of {}", next, asset.records.size());
}

void checkCounts(const LoadedAsset& loaded, const Reporter& report) {
  const Asset& asset = loaded.asset;
  if (!loaded.present.has({chunk::kInfo})) return;
  const auto count = [&](uint32_t type, uint64_t actual, uint64_t recorded) {
    if (loaded.present.has({type}) && actual != recorded)
      report(counts, type, "", "{} entries, INFO says {}", actual, recorded);
  };
  count(chunk::kVertices, asset.vertices.size(), asset.info.vertexCount);
  count(chunk::kTriangles, asset.triangles.size(), asset.info.triangleCount);
  count(chunk::kMaterials, asset.materials.size(), asset.info.materialCount);
  count(chunk::kTextures, asset.textures.size(), asset.info.textureCount);
  count(chunk::kRecords, asset.records.size(), asset.info.recordCount);
  count(chunk::kTiles, asset.tiles.size(), asset.info.tileCount);
  if (loaded.present.has({chunk::kStreamMasks}) && loaded.present.has({chunk::kPageIndex}) &&
      loaded.pageIndex.size() != asset.streamMasks.size())
    report(counts, chunk::kPageIndex, "", "{} entries, MASK has {}", loaded.pageIndex.size(),
           asset.streamMasks.size());
}

void checkTables(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (present.has({chunk::kInfo})) checkInfo(asset.info, report);
  checkMesh(asset, present, report);
  checkMaterials(asset, present, report);
  checkMaterialExtensions(asset, present, report);
  checkTextures(asset, present, report);
  checkAtlas(asset, present, report);
  checkTiles(asset, present, report);
  checkMasks(asset, present, report);
  checkSplit(asset, present, report);
  checkCells(asset, present, report);
  checkCoarseViews(asset, present, report);
}

}  // namespace boxlight::asset
