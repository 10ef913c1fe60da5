// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>

#include "common/asset/asset_checks.h"

namespace boxlight::asset {

using enum FindingCode;

void checkSplit(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (!present.has({chunk::kRecords, chunk::kVisibilityMaps})) return;
  const auto split = size_t(std::count_if(asset.records.begin(), asset.records.end(),
                                          [](const TexelRecord& r) { return (r.flags & kSplitLobe) != 0; }));
  if (split != asset.visibilityMaps.size())
    report(visibilityMaps, chunk::kVisibilityMaps, "", "{} maps for {} split records",
           asset.visibilityMaps.size(), split);
  if (split > 0 && asset.scheme == Scheme::sketch)
    report(visibilityMaps, chunk::kRecords, "", "{} split records in a file of the scheme {}", split,
           schemeName(asset.scheme));
}

void checkSlotKinds(const Asset& asset, uint32_t stream, uint32_t tile, std::span<const PackedBox> page,
                    const Reporter& report) {
  if (stream != asset.diffuseStream() && std::any_of(page.begin(), page.end(), isCosineBox))
    report(boxKind, chunk::kPages, pagePlace(asset, stream, tile), "a cosine box in a glossy kernel");
  const size_t slots = asset.boxesPerKernel(stream, tile);
  uint64_t left = asset.mask(stream, tile);
  for (size_t first = 0; left != 0 && first + slots <= page.size(); first += slots, left &= left - 1) {
    const auto kernel = page.subspan(first, slots);
    const uint32_t record = asset.tiles[tile].firstRecord + uint32_t(std::countr_zero(left));
    if (record >= asset.records.size()) return;  // the mask has said so
    const bool split = stream != asset.diffuseStream() && asset.isSplit(record);
    const size_t place = isEmission(kernel[0]) ? 1 : 0;
    const auto count = size_t(std::count_if(kernel.begin(), kernel.end(), isHiddenPart));
    const bool placed = place < slots && isHiddenPart(kernel[place]);
    if (split ? count == 1 && placed : count == 0) continue;
    report(hiddenPart, chunk::kPages, fmt::format("{}, record {}", pagePlace(asset, stream, tile), record),
           "{} slots of a {} record's kernel are hidden parts", count, split ? "split" : "whole");
  }
}

}  // namespace boxlight::asset
