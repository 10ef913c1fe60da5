// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/visibility_maps.h"

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

std::vector<uint32_t> gather(const asset::Asset& asset, std::span<const VisibleRecord> visible) {
  const std::vector<uint32_t> places = mapsOfRecords(asset);
  std::vector<uint32_t> words(places.size(), kAbsent);
  for (const auto& [r, glossy] : visible) {
    if (!glossy || places[r] == kAbsent) continue;
    const size_t place = words.size();
    words[r] = uint32_t(place);
    words.resize(place + kMapWords);
    std::memcpy(&words[place], &asset.visibilityMaps[places[r]], sizeof(VisibilityMap));
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
