// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "common/asset/asset_format.h"
#include "common/light/visibility_map.h"

namespace boxlight::asset {

/// Everything in a .ptb but the box pages: what a bake starts from and what both programs keep in memory.
struct Asset {
  Scheme scheme = Scheme::sketch;
  nlohmann::ordered_json provenance;  ///< tool version, options, scene hash, seed
  Info info{};                        ///< the counts are set by the writer from the vectors below
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  std::vector<MaterialExtension> materialExtensions;  ///< one for each material, or empty if none has any
  std::vector<TextureTransform> textureTransforms;
  std::vector<Texture> textures;
  std::vector<uint32_t> texels;  ///< RGBA8, R in the low byte
  std::vector<AtlasTexel> atlas;
  std::vector<TexelRecord> records;
  std::vector<Tile> tiles;
  std::vector<VisibilityMap> visibilityMaps;  ///< of the records with kSplitLobe, in their order
  std::vector<CellSphere> cellSphere;         ///< one of Scheme::cells, else none
  std::vector<uint64_t> streamMasks;          ///< [stream * tileCount + tile]

  uint32_t cellCount() const { return cellSphere.empty() ? 0 : cellSphere.front().count; }
  uint32_t streamCount() const { return info.viewCount + 1 + cellCount(); }
  bool isSplit(uint32_t record) const { return (records[record].flags & kSplitLobe) != 0; }
  bool hasCells(uint32_t record) const { return (records[record].flags & kDirectionCells) != 0; }
  uint32_t diffuseStream() const { return info.viewCount; }
  uint32_t firstCellStream() const { return info.viewCount + 1; }
  uint64_t mask(uint32_t stream, uint32_t tile) const {
    return streamMasks[size_t(stream) * tiles.size() + tile];
  }
  uint32_t boxesPerKernel(uint32_t stream, uint32_t tile) const {
    return stream == diffuseStream() ? tiles[tile].diffuseBoxes : tiles[tile].glossyBoxes;
  }
};

}  // namespace boxlight::asset
