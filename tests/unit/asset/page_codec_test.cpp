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

/// The document's own words (docs/format.md, "Planes"), for one kernel of two boxes.
TEST(PageCodec, LaysBytesOutAsTheDocumentSays) {
  const PackedBox boxes[2] = {{64, 128, 63, 127, {4, 8, 1024}, 3}, {}};
  const std::vector<std::byte> planes = boxesToPlanes(boxes, 2);
  const auto first = [&](size_t plane) { return int(planes[2 * plane]); };
  EXPECT_EQ(first(0), 3) << "kind, low";
  for (const size_t edge : {6, 7, 8, 9}) EXPECT_EQ(first(edge), 1) << "u0, v0, width, height, low";
  EXPECT_EQ(first(13), 1) << "red, low";
  EXPECT_EQ(first(14), 2) << "green, low";
  EXPECT_EQ(first(12), 1) << "blue, high";
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

TEST(PageCodec, NoSlotsNoBoxes) { planesToBoxes({}, 0, {}); }

}  // namespace
}  // namespace boxlight::asset
