// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <glm/gtc/packing.hpp>

#include "common/asset/asset_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

// Under a constant environment of 1 no surface returns more than 1; Monte Carlo noise and boxes that do not
// sum exactly to their kernel go above it, but not by this much.
constexpr float kEnergyAlarm = 4.0f;

/// Adds the box's energy to `sum`; false if it is not finite and non-negative.
bool addEnergy(const PackedBox& box, Rgb& sum) {
  for (int c = 0; c < 3; ++c) {
    const float energy = glm::unpackHalf1x16(box.energy[c]);
    if (!(energy >= 0.0f && energy <= 65504.0f)) return false;
    sum[c] += energy;
  }
  return true;
}

void checkPageEntry(const LoadedAsset& loaded, uint32_t stream, uint32_t tile, uint64_t pagesSize,
                    const Reporter& report) {
  const Asset& asset = loaded.asset;
  const PageEntry& page = loaded.pageIndex[size_t(stream) * asset.tiles.size() + tile];
  const uint64_t expected = pageBoxCount(asset, stream, tile) * sizeof(PackedBox);
  if (page.rawSize != expected || (expected == 0) != (page.storedSize == 0))
    report(pageSize, chunk::kPageIndex, pagePlace(asset, stream, tile),
           "{} bytes from {} stored ones, expected {}", page.rawSize, page.storedSize, expected);
  if (page.offset > pagesSize || pagesSize - page.offset < page.storedSize)
    report(pageRange, chunk::kPageIndex, pagePlace(asset, stream, tile), "{} bytes from {}, PAGE has {}",
           page.storedSize, page.offset, pagesSize);
}

}  // namespace

std::string pagePlace(const Asset& asset, uint32_t stream, uint32_t tile) {
  return stream == asset.diffuseStream() ? fmt::format("diffuse, tile {}", tile)
                                         : fmt::format("view {}, tile {}", stream, tile);
}

uint64_t pageBoxCount(const Asset& asset, uint32_t stream, uint32_t tile) {
  return uint64_t(std::popcount(asset.mask(stream, tile))) * asset.boxesPerKernel(stream, tile);
}

bool pagesCanBeFound(const LoadedAsset& loaded) {
  const Asset& asset = loaded.asset;
  const uint64_t pages = (uint64_t(asset.info.viewCount) + 1) * asset.tiles.size();
  return loaded.present.has(
             {chunk::kInfo, chunk::kTiles, chunk::kStreamMasks, chunk::kPageIndex, chunk::kPages}) &&
         asset.streamMasks.size() == pages && loaded.pageIndex.size() == pages;
}

void checkPageIndex(const LoadedAsset& loaded, uint64_t pagesSize, const Reporter& report) {
  const size_t tiles = loaded.asset.tiles.size();
  for (size_t i = 0; i < loaded.pageIndex.size(); ++i)
    checkPageEntry(loaded, uint32_t(i / tiles), uint32_t(i % tiles), pagesSize, report);
}

bool pageIsSound(const LoadedAsset& loaded, uint32_t stream, uint32_t tile, uint64_t pagesSize) {
  bool sound = loaded.asset.boxesPerKernel(stream, tile) <= kMaxBoxesPerKernel;
  checkPageEntry(loaded, stream, tile, pagesSize, Reporter([&](const Finding&) { sound = false; }));
  return sound;
}

void checkBoxes(std::span<const PackedBox> boxes, uint32_t boxesPerKernel, const std::string& place,
                const Reporter& report) {
  for (size_t first = 0; first < boxes.size(); first += boxesPerKernel) {
    Rgb sum(0.0f);
    for (size_t i = first; i < first + boxesPerKernel; ++i) {
      const PackedBox& box = boxes[i];
      const auto at = [&] {
        return fmt::format("{}, kernel {}, box {}", place, first / boxesPerKernel, i - first);
      };
      if (uint32_t(box.v0) + box.dv > 65535)
        report(boxRange, chunk::kPages, at(), "v0 {} and dv {} reach beyond 65536", box.v0, box.dv);
      if (!addEnergy(box, sum))
        report(boxEnergy, chunk::kPages, at(), "half floats {:#06x} {:#06x} {:#06x}", box.energy[0],
               box.energy[1], box.energy[2]);
      if (box.kind > kEmittedRadiance) report(reserved, chunk::kPages, at(), "kind {}", box.kind);
    }
    if (maxComponent(sum) > kEnergyAlarm)
      report(kernelEnergy, chunk::kPages, fmt::format("{}, kernel {}", place, first / boxesPerKernel),
             "energy {:.3g} {:.3g} {:.3g}", sum.x, sum.y, sum.z);
  }
}

}  // namespace boxlight::asset
