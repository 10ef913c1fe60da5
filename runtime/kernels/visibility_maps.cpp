// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/visibility_maps.h"

#include <array>
#include <cstring>

#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

constexpr size_t kMapWords = sizeof(VisibilityMap) / sizeof(uint32_t);

/// By record its place in asset.visibilityMaps, or kAbsent.
std::vector<uint32_t> mapsOfRecords(const asset::Asset& asset) {
  std::vector<uint32_t> places(asset.records.size(), kAbsent);
  uint32_t next = 0;
  for (uint32_t r = 0; r < places.size(); ++r)
    if (asset.isSplit(r)) places[r] = next++;
  return places;
}

/// shaders/visibility_maps.glsl: blocksOf.
std::array<uint32_t, kMapBlockWords> hiddenBlocks(const VisibilityMap& map) {
  constexpr uint32_t kBlockCells = 8;
  std::array<uint32_t, kMapBlockWords> blocks{};
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) {
      const uint32_t column = x / kBlockCells, row = y / kBlockCells;
      if (!map.isVisible(x, y)) blocks[row / 2] |= 1u << (row % 2 * 16 + column);
    }
  return blocks;
}

std::vector<uint32_t> gather(const asset::Asset& asset, std::span<const VisibleRecord> visible) {
  const std::vector<uint32_t> places = mapsOfRecords(asset);
  std::vector<uint32_t> words(places.size(), kAbsent);
  for (const auto& [r, glossy] : visible) {
    if (!glossy || places[r] == kAbsent) continue;
    const size_t place = words.size();
    words[r] = uint32_t(place);
    const VisibilityMap& map = asset.visibilityMaps[places[r]];
    const auto blocks = hiddenBlocks(map);
    words.insert(words.end(), blocks.begin(), blocks.end());
    words.resize(words.size() + kMapWords);
    std::memcpy(&words[place + kMapBlockWords], &map, sizeof map);
  }
  return words;
}

}  // namespace

VisibilityMaps::VisibilityMaps(Device& device, Bindings& bindings, const asset::Asset& asset,
                               std::span<const VisibleRecord> visible)
    : buffer_(makeBuffer(device, "visibility maps", gather(asset, visible))) {
  bindings.set(kBindVisibilityMaps, buffer_);
}

}  // namespace boxlight::gpu
