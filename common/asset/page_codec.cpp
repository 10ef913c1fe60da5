// SPDX-License-Identifier: Apache-2.0
#include "common/asset/page_codec.h"

#include <array>
#include <bit>
#include <cassert>
#include <cstring>

namespace boxlight::asset {
namespace {

constexpr size_t kWords = sizeof(PackedBox) / 2;
using Words = std::array<uint16_t, kWords>;

/// The order of planes: bytes of the turned words, what says little first and noise last.
constexpr std::array<uint8_t, 2 * kWords> kPlanes = {14, 15, 1, 3, 5, 7, 0, 2, 4, 6, 9, 11, 13, 8, 10, 12};
/// Planes that share a block.
constexpr std::array<size_t, 4> kGroups = {6, 4, 3, 3};
constexpr size_t kLeastInBlocks = 64;  ///< boxes; in smaller pages the blocks' heads cost more than they save

/// Bits that words are turned right by: edges lie on a raster of 1/1024 in u and 1/512 in v (a fitter's), of
/// energies of light boxes the last two bits are 0 (packBox).
constexpr std::array<int, kWords> kTurns = {6, 7, 6, 7, 2, 2, 2, 0};
constexpr size_t kWidth = 2, kHeight = 3;  ///< stored less 1, turned as they are

Words turned(const PackedBox& box) {
  auto words = std::bit_cast<Words>(box);
  ++words[kWidth], ++words[kHeight];
  for (size_t w = 0; w < kWords; ++w) words[w] = std::rotr(words[w], kTurns[w]);
  return words;
}

PackedBox turnedBack(Words words) {
  for (size_t w = 0; w < kWords; ++w) words[w] = std::rotl(words[w], kTurns[w]);
  --words[kWidth], --words[kHeight];
  return std::bit_cast<PackedBox>(words);
}

/// Where box i lies in a plane: slot after slot, in each kernel after kernel.
struct PlaneOrder {
  size_t operator()(size_t i) const { return i % slots * kernels + i / slots; }
  size_t slots, kernels;
};

}  // namespace

std::vector<std::byte> boxesToPlanes(std::span<const PackedBox> boxes, uint32_t slots) {
  assert(slots > 0);
  std::vector<std::byte> planes(boxes.size_bytes());
  const PlaneOrder place{slots, boxes.size() / slots};
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Words words = turned(boxes[i]);
    for (size_t p = 0; p < kPlanes.size(); ++p)
      planes[p * boxes.size() + place(i)] = std::byte(words[kPlanes[p] / 2] >> 8 * (kPlanes[p] % 2));
  }
  return planes;
}

void planesToBoxes(std::span<const std::byte> planes, uint32_t slots, std::span<PackedBox> boxes) {
  if (boxes.empty()) return;  // of a tile without slots, too
  const PlaneOrder place{slots, boxes.size() / slots};
  for (size_t i = 0; i < boxes.size(); ++i) {
    Words words{};
    for (size_t p = 0; p < kPlanes.size(); ++p)
      words[kPlanes[p] / 2] |=
          uint16_t(uint16_t(planes[p * boxes.size() + place(i)]) << 8 * (kPlanes[p] % 2));
    boxes[i] = turnedBack(words);
  }
}

std::span<const std::byte> compressPage(FrameCompressor& compressor, std::span<const PackedBox> boxes,
                                        uint32_t slots) {
  if (boxes.size() < kLeastInBlocks) return compressor.compress(boxesToPlanes(boxes, slots));
  std::array<size_t, kGroups.size()> blocks;
  for (size_t g = 0; g < kGroups.size(); ++g) blocks[g] = kGroups[g] * boxes.size();
  return compressor.compress(boxesToPlanes(boxes, slots), blocks);
}

}  // namespace boxlight::asset
