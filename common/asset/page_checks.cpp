// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "common/asset/asset_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

// Under a constant environment of 1 no surface returns more than 1; Monte Carlo noise and boxes that do not
// sum exactly to their kernel go above it, but not by this much.
constexpr float kEnergyAlarm = 4.0f;

/// False if it is not finite, or negative where no cosine box's amplitude is meant.
bool readEnergy(const PackedBox& box, Rgb& energy) {
  const float least = isCosineBox(box) ? -65504.0f : 0.0f;
  bool valid = true;
  for (int c = 0; c < 3; ++c) {
    energy[c] = glm::unpackHalf1x16(box.energy[c]);
    valid &= energy[c] >= least && energy[c] <= 65504.0f;
  }
  return valid;
}

/// Edges of a box inside the light domain, of a cosine box on its raster, emitted radiance inside single
/// precision?
bool inRange(const PackedBox& box) {
  if (isHiddenPart(box)) return true;
  const uint32_t end = uint32_t(box.v0) + box.dv + 1;
  if (isCosineBox(box)) return end <= 65536 && box.v0 % kCosineRaster == 0 && end % kCosineRaster == 0;
  if (!isEmission(box)) return end <= 65536;
  const int exponent = int(box.du) - 32768;
  return exponent >= kMinEmissionExponent && exponent <= kMaxEmissionExponent &&
         maxComponent(unpackEmission(box)) <= std::numeric_limits<float>::max();
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
  if (stream == asset.diffuseStream()) return fmt::format("diffuse, tile {}", tile);
  const bool isCell = stream >= asset.firstCellStream();
  return fmt::format("{} {}, tile {}", isCell ? "cell" : "view",
                     isCell ? stream - asset.firstCellStream() : stream, tile);
}

uint64_t pageBoxCount(const Asset& asset, uint32_t stream, uint32_t tile) {
  return uint64_t(std::popcount(asset.mask(stream, tile))) * asset.boxesPerKernel(stream, tile);
}

bool pagesCanBeFound(const LoadedAsset& loaded) {
  const Asset& asset = loaded.asset;
  if (!loaded.present.has({chunk::kTiles, chunk::kStreamMasks, chunk::kPageIndex, chunk::kPages}) ||
      !streamsCanBeCounted(asset, loaded.present))
    return false;
  const uint64_t pages = uint64_t(asset.streamCount()) * asset.tiles.size();
  return asset.streamMasks.size() == pages && loaded.pageIndex.size() == pages;
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
  Rgb sum(0.0f);
  for (size_t i = 0; i < boxes.size(); ++i) {
    const PackedBox& box = boxes[i];
    const size_t slot = i % boxesPerKernel;
    const auto kernel = [&] { return fmt::format("{}, kernel {}", place, i / boxesPerKernel); };
    const auto bad = [&]<class... Args>(FindingCode code, fmt::format_string<Args...> format,
                                        Args&&... args) {
      report(code, chunk::kPages, fmt::format("{}, box {}", kernel(), slot), format,
             std::forward<Args>(args)...);
    };
    if (slot == 0) sum = Rgb(0.0f);
    if (box.kind > kCosineBox || (slot > 0 && isEmission(box))) bad(boxKind, "kind {}", box.kind);
    if (slot == 0 && isEmission(box) != isEmission(boxes[0]))
      bad(emittedSlots, "kind {}, the page's first kernel has {}", box.kind, boxes[0].kind);
    if (!inRange(box)) bad(boxRange, "kind {}, v0 {}, dv {}, du {}", box.kind, box.v0, box.dv, box.du);
    Rgb energy;
    if (!readEnergy(box, energy))
      bad(boxEnergy, "half floats {:#06x} {:#06x} {:#06x}", box.energy[0], box.energy[1], box.energy[2]);
    else if (box.kind == kLightBox)
      sum += energy;
    if (slot + 1 == boxesPerKernel && maxComponent(sum) > kEnergyAlarm)
      report(kernelEnergy, chunk::kPages, kernel(), "energy {:.3g} {:.3g} {:.3g}", sum.x, sum.y, sum.z);
  }
}

void EmittedSlots::check(uint32_t stream, uint32_t tile, std::span<const PackedBox> page,
                         const Reporter& report) {
  if (page.empty()) return;
  const Seen found = isEmission(page[0]) ? kEmitted : kBoxes;
  if (found == kEmitted && asset_.materialExtensions.empty())
    report(extensionMissing, chunk::kPages, pagePlace(asset_, stream, tile), "emitted radiance without MATX");
  Seen before = kNoPage;
  if (!seen_[tile][stream == asset_.diffuseStream()].compare_exchange_strong(before, found) &&
      before != found)
    report(emittedSlots, chunk::kPages, pagePlace(asset_, stream, tile),
           "{} emitted radiance, another view has {}", found == kEmitted ? "with" : "without",
           found == kEmitted ? "none" : "some");
}

}  // namespace boxlight::asset
