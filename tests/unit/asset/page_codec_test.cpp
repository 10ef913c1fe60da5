// SPDX-License-Identifier: Apache-2.0
#include "common/asset/page_codec.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace boxlight::asset {
namespace {

std::vector<PackedBox> randomBoxes(size_t count) {
  std::mt19937 random(7);
  std::vector<PackedBox> boxes(count);
  for (PackedBox& box : boxes)
    for (size_t word = 0; word < 8; ++word) {
      const auto value = uint16_t(random());
      std::memcpy(reinterpret_cast<std::byte*>(&box) + 2 * word, &value, 2);
    }
  return boxes;
}

bool same(std::span<const PackedBox> a, std::span<const PackedBox> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST(PageCodec, GivesBackAnyBox) {
  for (const uint32_t slots : {1u, 2u, 5u, 256u}) {
    std::vector<PackedBox> boxes = randomBoxes(size_t(slots) * 7);
    boxes[0] = {65535, 65535, 65535, 65535, {65535, 65535, 65535}, 65535};
    boxes.back() = {};
    std::vector<PackedBox> back(boxes.size());
    planesToBoxes(boxesToPlanes(boxes, slots), slots, back);
    EXPECT_TRUE(same(boxes, back)) << slots;
  }
}

/// The example of docs/format.md, "Planes", and an empty box behind it.
TEST(PageCodec, LaysBytesOutAsTheDocumentSays) {
  const PackedBox boxes[2] = {{64, 2 * 128, 3 * 64 - 1, 4 * 128 - 1, {4, 8, 1024}, 3}, {}};
  const std::vector<std::byte> planes = boxesToPlanes(boxes, 2);
  const int expected[16] = {3, 0, 0, 0, 0, 0, 1, 2, 3, 4, 0, 0, 1, 1, 2, 0};
  for (size_t plane = 0; plane < 16; ++plane) EXPECT_EQ(int(planes[2 * plane]), expected[plane]) << plane;
  EXPECT_EQ(int(planes[2 * 4 + 1]), 4) << "a width of one step is bit 10: 1 turned right by 6";
}

TEST(PageCodec, SlotsOfAllKernelsLieTogether) {
  std::vector<PackedBox> boxes(6);  // three kernels of two boxes
  for (size_t i = 0; i < boxes.size(); ++i) boxes[i].kind = uint16_t(i);
  const std::vector<std::byte> planes = boxesToPlanes(boxes, 2);
  const int expected[] = {0, 2, 4, 1, 3, 5};
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(int(planes[i]), expected[i]);
}

TEST(PageCodec, APageIsOneFrameInBlocksOrNot) {
  FrameCompressor compressor;
  for (const uint32_t kernels : {1u, 15u, 16u, 64u}) {  // 16: the first in blocks
    const std::vector<PackedBox> boxes = randomBoxes(4 * size_t(kernels));
    const auto stored = compressPage(compressor, boxes, 4);
    std::vector<std::byte> planes(boxes.size() * sizeof(PackedBox));
    ASSERT_TRUE(decompressFrame(stored, planes)) << kernels;
    std::vector<PackedBox> back(boxes.size());
    planesToBoxes(planes, 4, back);
    EXPECT_TRUE(same(boxes, back)) << kernels;
    EXPECT_FALSE(decompressFrame(stored.first(stored.size() - 1), planes));
    const std::vector<std::byte> once(stored.begin(), stored.end());
    const auto again = compressPage(compressor, boxes, 4);
    EXPECT_TRUE(std::equal(once.begin(), once.end(), again.begin(), again.end())) << "same bytes";
  }
}

/// How many blocks a zstd frame with a content size and no checksum has (RFC 8878, section 3.1.1).
size_t blocksOf(std::span<const std::byte> frame) {
  const auto byte = [&](size_t i) { return uint32_t(frame[i]); };
  const uint32_t descriptor = byte(4);
  const size_t sizeBytes = descriptor >> 6 ? size_t(1) << (descriptor >> 6) : descriptor >> 5 & 1;
  size_t at = 5 + (descriptor >> 5 & 1 ? 0 : 1) + sizeBytes, blocks = 0;
  for (bool last = false; !last; ++blocks) {
    const uint32_t head = byte(at) | byte(at + 1) << 8 | byte(at + 2) << 16;
    last = head & 1;
    at += 3 + ((head >> 1 & 3) == 1 ? 1 : head >> 3);  // an RLE block is one byte
  }
  EXPECT_EQ(at, frame.size());
  return blocks;
}

TEST(PageCodec, PagesOf64BoxesAndMoreHaveABlockForEachKindOfPlane) {
  FrameCompressor compressor;
  const std::vector<PackedBox> boxes = randomBoxes(128);
  EXPECT_EQ(blocksOf(compressPage(compressor, std::span(boxes).first(63), 3)), 1u);
  EXPECT_EQ(blocksOf(compressPage(compressor, std::span(boxes).first(64), 4)), 4u);
  EXPECT_EQ(blocksOf(compressPage(compressor, boxes, 4)), 4u);
}

/// It has failed if it divides by zero.
TEST(PageCodec, ATileWithoutSlotsHasNoBoxes) {
  std::vector<PackedBox> boxes;
  planesToBoxes({}, 0, boxes);
  EXPECT_TRUE(boxes.empty());
}

}  // namespace
}  // namespace boxlight::asset
