// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "common/asset/asset.h"
#include "common/asset/chunk_file.h"

namespace boxlight::asset {

/// Calls f(chunk type, vector) for each array that Asset holds, in the order in which the writer writes them.
/// What is in no file before it has entries: see isOptionalTable (chunk_file.h).
template <class A, class F>
void forEachTable(A& asset, F&& f) {
  f(chunk::kVertices, asset.vertices);
  f(chunk::kTriangles, asset.triangles);
  f(chunk::kMaterials, asset.materials);
  f(chunk::kMaterialExtensions, asset.materialExtensions);
  f(chunk::kTextureTransforms, asset.textureTransforms);
  f(chunk::kTextures, asset.textures);
  f(chunk::kTexels, asset.texels);
  f(chunk::kAtlas, asset.atlas);
  f(chunk::kAtlasLevels, asset.atlasLevels);
  f(chunk::kRecords, asset.records);
  f(chunk::kTiles, asset.tiles);
  f(chunk::kVisibilityMaps, asset.visibilityMaps);
  f(chunk::kCellSphere, asset.cellSphere);
  f(chunk::kCoarseViews, asset.coarseViews);
  f(chunk::kStreamMasks, asset.streamMasks);
}

/// Which chunks of a file could be read. An optional table that is not in the file counts as read, and empty.
class ChunkSet {
 public:
  void add(uint32_t type) { types_.push_back(type); }
  bool has(std::initializer_list<uint32_t> types) const {
    return std::all_of(types.begin(), types.end(), [&](uint32_t type) {
      return std::find(types_.begin(), types_.end(), type) != types_.end();
    });
  }

 private:
  std::vector<uint32_t> types_;
};

struct LoadedAsset {
  Asset asset;
  std::vector<PageEntry> pageIndex;
  ChunkSet present;
};

/// Reads every chunk but the pages. Values are as in the file: checkTables (asset_checks.h) looks at them.
LoadedAsset loadAsset(const ChunkFile& file, const Reporter& report);

}  // namespace boxlight::asset
