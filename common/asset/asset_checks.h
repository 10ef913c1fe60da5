// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "common/asset/asset_load.h"

namespace boxlight::asset {

/// Checks every value of `asset` against docs/format.md: numbers finite, indices in range, tables consistent.
/// Looks only at the chunks that are present. What reports no error can be used without a further check. The
/// counts in Info are not looked at.
void checkTables(const Asset& asset, const ChunkSet& present, const Reporter& report);

/// The parts of checkTables.
void checkMesh(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkMaterials(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkMaterialExtensions(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkTextures(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkAtlas(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkTiles(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkMasks(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkSplit(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkCells(const Asset& asset, const ChunkSet& present, const Reporter& report);
void checkCoarseViews(const Asset& asset, const ChunkSet& present, const Reporter& report);

/// Could INFO be read, and are views and cells as many as their frequencies have? Only then is
/// Asset::streamCount() to be trusted, and small. (Coarse views have no streams of their own.)
bool streamsCanBeCounted(const Asset& asset, const ChunkSet& present);

/// Does each table have as many entries as Info says?
void checkCounts(const LoadedAsset& loaded, const Reporter& report);

/// Are all the tables there, with fitting sizes, that finding a page takes?
bool pagesCanBeFound(const LoadedAsset& loaded);

/// Does each page lie in PAGE, of `pagesSize` stored bytes, and is its raw size that of its kernels? Requires
/// pagesCanBeFound.
void checkPageIndex(const LoadedAsset& loaded, uint64_t pagesSize, const Reporter& report);

/// Has checkPageIndex nothing to say about this page, and are its boxes within the limit?
bool pageIsSound(const LoadedAsset& loaded, uint32_t stream, uint32_t tile, uint64_t pagesSize);

/// Do the textures of a material record, their coordinate sets and their transforms exist?
void checkReferences(const Asset& asset, const ChunkSet& present, const Material& material,
                     const std::string& place, const Reporter& report);
void checkReferences(const Asset& asset, const ChunkSet& present, const MaterialExtension& extension,
                     const std::string& place, const Reporter& report);

/// The boxes of one page, kernel after kernel.
void checkBoxes(std::span<const PackedBox> boxes, uint32_t boxesPerKernel, const std::string& place,
                const Reporter& report);

/// Have exactly the glossy kernels of split records a hidden part, behind emitted radiance and before the
/// boxes? Have only Lambert kernels cosine boxes?
void checkSlotKinds(const Asset& asset, uint32_t stream, uint32_t tile, std::span<const PackedBox> page,
                    const Reporter& report);

/// Do the pages of a tile agree, of its glossy streams and of its Lambert stream each, on whether their
/// kernels begin with emitted radiance? (checkBoxes looks inside one page.) Does a file that has any have
/// MATX? Pages may come in any order and from several threads.
class EmittedSlots {
 public:
  explicit EmittedSlots(const Asset& asset) : asset_(asset), seen_(asset.tiles.size()) {}
  void check(uint32_t stream, uint32_t tile, std::span<const PackedBox> page, const Reporter& report);

 private:
  const Asset& asset_;
  enum Seen : uint8_t { kNoPage, kBoxes, kEmitted };
  std::vector<std::array<std::atomic<Seen>, 2>> seen_;  // per tile: glossy, Lambert
};

/// Boxes in the page of one stream of one tile.
uint64_t pageBoxCount(const Asset& asset, uint32_t stream, uint32_t tile);

/// "view 12, tile 3" or "diffuse, tile 3"
std::string pagePlace(const Asset& asset, uint32_t stream, uint32_t tile);

}  // namespace boxlight::asset
