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
  std::vector<AtlasTexel> atlasLevels;  ///< of its coarser levels 1, 2, ..., one after another
  std::vector<TexelRecord> records;
  std::vector<Tile> tiles;
  std::vector<VisibilityMap> visibilityMaps;  ///< of the records with kSplitLobe, in their order
  std::vector<GeodesicSphere> cellSphere;     ///< one of Scheme::cells, else none
  std::vector<GeodesicSphere> coarseViews;    ///< of falling frequency, below that of Info
  std::vector<uint64_t> streamMasks;          ///< [stream * tileCount + tile]

  /// Texels each way of a level of the atlas: half as many as of the one before, rounded down, but one.
  uvec2 levelSize(uint32_t level) const {
    return glm::max(uvec2(info.atlasWidth >> level, info.atlasHeight >> level), uvec2(1));
  }
  /// Levels of the atlas, itself included; 0 if atlasLevels is not a whole number of levels.
  uint32_t levelCount() const;
  uint32_t cellCount() const { return cellSphere.empty() ? 0 : cellSphere.front().count; }
  uint32_t streamCount() const { return info.viewCount + 1 + cellCount(); }
  bool isSplit(uint32_t record) const { return (records[record].flags & kSplitLobe) != 0; }
  bool hasCells(uint32_t record) const { return (records[record].flags & kDirectionCells) != 0; }
  /// Of a record's views: 0 is the sphere of Info, others are coarseViews[number - 1].
  uint32_t viewSphere(uint32_t record) const { return viewSphereOf(records[record].flags); }
  uint32_t diffuseStream() const { return info.viewCount; }
  uint32_t firstCellStream() const { return info.viewCount + 1; }
  uint64_t mask(uint32_t stream, uint32_t tile) const {
    return streamMasks[size_t(stream) * tiles.size() + tile];
  }
  uint32_t boxesPerKernel(uint32_t stream, uint32_t tile) const {
    return stream == diffuseStream() ? tiles[tile].diffuseBoxes : tiles[tile].glossyBoxes;
  }
};

inline uint32_t Asset::levelCount() const {
  size_t left = atlasLevels.size();
  for (uint32_t level = 1;; ++level) {
    if (left == 0) return level;
    if (levelSize(level - 1) == uvec2(1)) return 0;
    const uvec2 size = levelSize(level);
    if (size_t(size.x) * size.y > left) return 0;
    left -= size_t(size.x) * size.y;
  }
}

}  // namespace boxlight::asset
