// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/visibility_maps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

/// As the shaders find it: which blocks have hidden cells, the visible parts of quarters of blocks, the rows.
struct BlockedMap {
  std::array<uint32_t, kMapBlockWords> hiddenBlocks;
  std::array<uint32_t, kMapQuarterWords> quarters;
  VisibilityMap map;
};
constexpr uint32_t kMapWords = sizeof(BlockedMap) / sizeof(uint32_t);

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

std::array<double, VisibilityMap::kRows> makeRowWeights() {
  std::array<double, VisibilityMap::kRows> weights;
  for (size_t y = 0; y < weights.size(); ++y)
    weights[y] = std::sin(kPiDouble * (double(y) + 0.5) / VisibilityMap::kRows);
  return weights;
}

/// shaders/visibility_maps.glsl: quarterColumn. Only what is all visible is 255, only what is all hidden 0.
std::array<uint32_t, kMapQuarterWords> visibleQuarters(const VisibilityMap& map) {
  static const auto rowWeights = makeRowWeights();
  constexpr uint32_t kSide = 4;
  std::array<uint32_t, kMapQuarterWords> words{};
  for (uint32_t y = 0; y < VisibilityMap::kRows / kSide; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns / kSide; ++x) {
      double visible = 0, all = 0;
      int cells = 0;
      for (uint32_t row = kSide * y; row < kSide * (y + 1); ++row) {
        const int seen = std::popcount(map.row(row)[x / 8] >> 4 * (x % 8) & 15u);
        cells += seen, visible += rowWeights[row] * seen, all += rowWeights[row] * kSide;
      }
      const auto code = uint32_t(std::lround(255 * visible / all));
      const bool partial = cells > 0 && cells < int(kSide * kSide);
      words[4 * x + y / 4] |= (partial ? std::clamp(code, 1u, 254u) : code) << 8 * (y % 4);
    }
  return words;
}

/// Bytes that the device reads maps from at once.
uint64_t mostBytes(const DeviceLimits& limits) {
  const uint64_t texels = limits.texelBuffers ? limits.maxTexels * uint64_t(sizeof(uint32_t)) : ~uint64_t(0);
  return std::min(limits.maxStorageBufferRange, texels);
}

}  // namespace

VisibilityMaps::VisibilityMaps(Device& device, Bindings& bindings, const asset::Asset& asset)
    : device_(device),
      bindings_(bindings),
      asset_(asset),
      source_(mapsOfRecords(asset)),
      words_(asset.records.size(), kAbsent),
      buffer_(makeBuffer(device, "visibility maps", words_)) {
  bindings.set(kBindVisibilityMaps, buffer_);
}

uint64_t VisibilityMaps::bytesWith(size_t maps) const {
  return words_.size() * sizeof(uint32_t) + maps * sizeof(BlockedMap);
}

std::vector<uint32_t> VisibilityMaps::missing(std::span<const VisibleRecord> visible) const {
  std::vector<uint32_t> records;
  for (const auto& [r, glossy] : visible)
    if (glossy && source_[r] != kAbsent && words_[r] == kAbsent) records.push_back(r);
  return records;
}

void VisibilityMaps::require(std::span<const VisibleRecord> visible) {
  std::vector<uint32_t> records = missing(visible);
  if (records.empty()) return;
  const uint64_t limit = mostBytes(device_.limits());
  if (count_ > 0 && bytesWith(count_ + records.size()) > limit) {
    std::fill(words_.begin(), words_.end(), kAbsent);
    count_ = 0;
    records = missing(visible);
  }
  std::vector<BlockedMap> maps;
  for (const uint32_t r : records) {
    words_[r] = uint32_t(words_.size() + (count_ + maps.size()) * kMapWords);
    const VisibilityMap& map = asset_.visibilityMaps[source_[r]];
    maps.push_back({hiddenBlocks(map), visibleQuarters(map), map});
  }
  const uint64_t start = bytesWith(count_), end = bytesWith(count_ + maps.size());
  if (end > buffer_.size()) {  // exact at first, then with room for what the camera will see
    const uint64_t room = std::min(end + end / 2, std::max(limit, end));
    grow(device_, buffer_, "visibility maps", count_ == 0 ? end : room);
    bindings_.set(kBindVisibilityMaps, buffer_);
  }
  upload(device_, buffer_, std::as_bytes(std::span(words_)));
  upload(device_, buffer_, std::as_bytes(std::span(maps)), start);
  count_ += maps.size();
}

}  // namespace boxlight::gpu
