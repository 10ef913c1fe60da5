// SPDX-License-Identifier: Apache-2.0
// Which streams there are, and which records have kernels in them.
#include <algorithm>
#include <array>

#include "common/asset/asset_checks.h"
#include "common/asset/number_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

bool cellSphereIsSound(const Asset& asset) {
  if (asset.scheme != Scheme::cells) return asset.cellSphere.empty();
  if (asset.cellSphere.size() != 1) return false;
  const auto [frequency, count] = asset.cellSphere.front();
  return isFrequency(frequency) && count == sphereVertices(frequency);
}

void checkCellSphere(const Asset& asset, const Reporter& report) {
  if (cellSphereIsSound(asset)) return;
  if (asset.scheme != Scheme::cells || asset.cellSphere.size() != 1)
    return report(directionCells, chunk::kCellSphere, "", "{} entries in a file of the scheme {}",
                  asset.cellSphere.size(), schemeName(asset.scheme));
  report(directionCells, chunk::kCellSphere, "", "{} cells at frequency {}, allowed are frequencies 1 to {}",
         asset.cellSphere[0].count, asset.cellSphere[0].frequency, kMaxViewFrequency);
}

/// Fewer and fewer, so that the streams of INFO's views have room for all.
bool coarseViewsAreSound(const Asset& asset) {
  uint32_t above = asset.info.viewFrequency;
  for (const auto [frequency, count] : asset.coarseViews) {
    if (frequency < 1 || frequency >= above || count != sphereVertices(frequency)) return false;
    above = frequency;
  }
  return asset.coarseViews.size() <= kMaxCoarseViews;
}

/// Bit r: is it true of record r of the tile? Of records that do not exist it is not.
template <class Predicate>
uint64_t recordsWhere(const Asset& asset, const Tile& tile, Predicate&& holds) {
  uint64_t bits = 0;
  for (uint32_t r = 0; r < std::min(tile.recordCount, kTileRecords); ++r) {
    const uint64_t record = uint64_t(tile.firstRecord) + r;
    if (record < asset.records.size() && holds(uint32_t(record))) bits |= uint64_t(1) << r;
  }
  return bits;
}

void checkMask(const Asset& asset, uint32_t stream, uint32_t tile, const Reporter& report) {
  const uint64_t mask = asset.mask(stream, tile);
  const uint32_t records = asset.tiles[tile].recordCount;
  if (records < 64 && mask >> records != 0)
    report(maskBits, chunk::kStreamMasks, pagePlace(asset, stream, tile),
           "mask {:#x} of a tile of {} records", mask, records);
  if (mask != 0 && asset.boxesPerKernel(stream, tile) == 0)
    report(maskBits, chunk::kStreamMasks, pagePlace(asset, stream, tile),
           "mask {:#x}, but the kernels have no boxes", mask);
}

/// A record has its gloss in the streams of its own sphere's views, or in those of the cells.
void checkGlossyMasks(const Asset& asset, uint32_t tile, bool withViews, const Reporter& report) {
  const auto where = [&](auto&& holds) { return recordsWhere(asset, asset.tiles[tile], holds); };
  const uint64_t withCells = where([&](uint32_t record) { return asset.hasCells(record); });
  std::array<uint64_t, kMaxCoarseViews> ofSphere{};
  for (uint32_t s = 0; s < ofSphere.size(); ++s)
    ofSphere[s] = where([&](uint32_t record) { return asset.viewSphere(record) == s + 1; });
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream) {
    const uint64_t mask = asset.mask(stream, tile);
    if (stream == asset.diffuseStream() || mask == 0) continue;
    const auto refuse = [&](uint64_t strangers, const char* what) {
      if (strangers & mask)
        report(maskBits, chunk::kStreamMasks, pagePlace(asset, stream, tile), "bits {:#x} are of records {}",
               strangers & mask, what);
    };
    if (stream >= asset.firstCellStream()) {
      refuse(~withCells, "without direction cells");
      continue;
    }
    refuse(withCells, "with direction cells");
    for (uint32_t s = 0; withViews && s < asset.coarseViews.size() && s < ofSphere.size(); ++s)
      if (stream >= asset.coarseViews[s].count) refuse(ofSphere[s], "with fewer views");
  }
}

}  // namespace

bool streamsCanBeCounted(const Asset& asset, const ChunkSet& present) {
  const Info& info = asset.info;
  return present.has({chunk::kInfo}) && isFrequency(info.viewFrequency) &&
         info.viewCount == sphereVertices(info.viewFrequency) && cellSphereIsSound(asset);
}

void checkMasks(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (!present.has({chunk::kTiles, chunk::kStreamMasks}) || !streamsCanBeCounted(asset, present)) return;
  const uint64_t expected = uint64_t(asset.streamCount()) * asset.tiles.size();
  if (asset.streamMasks.size() != expected)
    return report(counts, chunk::kStreamMasks, "", "{} masks, expected {}", asset.streamMasks.size(),
                  expected);
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) checkMask(asset, stream, tile, report);
  if (!present.has({chunk::kRecords})) return;
  for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile)
    checkGlossyMasks(asset, tile, present.has({chunk::kCoarseViews}), report);
}

void checkCells(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (present.has({chunk::kCellSphere})) checkCellSphere(asset, report);
  for (uint32_t i = 0; i < asset.records.size(); ++i) {
    if (!asset.hasCells(i)) continue;
    if (asset.scheme != Scheme::cells)
      report(directionCells, chunk::kRecords, fmt::format("record {}", i),
             "direction cells in a file of the scheme {}", schemeName(asset.scheme));
    else if (!asset.isSplit(i))
      report(directionCells, chunk::kRecords, fmt::format("record {}", i),
             "direction cells without a split lobe");
  }
}

void checkCoarseViews(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (!present.has({chunk::kInfo, chunk::kCoarseViews})) return;
  if (!coarseViewsAreSound(asset))
    report(coarseViews, chunk::kCoarseViews, "",
           "not at most {} spheres, each of 10 f^2 + 2 views and coarser than the one before, the first than "
           "that of INFO",
           kMaxCoarseViews);
  for (uint32_t i = 0; i < asset.records.size(); ++i) {
    const uint32_t sphere = asset.viewSphere(i);
    if (sphere > asset.coarseViews.size())
      report(coarseViews, chunk::kRecords, fmt::format("record {}", i), "views of sphere {} of {}", sphere,
             asset.coarseViews.size());
    else if (sphere > 0 && asset.hasCells(i))
      report(coarseViews, chunk::kRecords, fmt::format("record {}", i),
             "coarse views beside direction cells");
  }
}

}  // namespace boxlight::asset
