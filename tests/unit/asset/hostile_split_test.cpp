// SPDX-License-Identifier: Apache-2.0
// What format 1.2 added, with values that no writer would write.
#include "tests/unit/asset/hostile.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

constexpr SampleSize kSplit{.split = true}, kSketch{};
// Of makeSample(kSplit), whose records 0, 2 and 3 are split, with the slots of their kernels:
constexpr size_t kPage = 0;          // records 0 and 2: hidden part, two boxes
constexpr size_t kMixedPage = 2;     // record 1: three boxes; record 2
constexpr size_t kEmittedPage = 5;   // record 3: emitted radiance, hidden part, two boxes
constexpr size_t kLambertPage = 25;  // records 3 and 4, without emitted radiance

std::function<void(Surgeon&)> resizeMaps(int64_t bytes) {
  return [=](Surgeon& s) {
    Bytes maps = s.chunk(chunk::kVisibilityMaps);
    maps.resize(size_t(int64_t(maps.size()) + bytes));
    s.setChunk(chunk::kVisibilityMaps, maps);
  };
}
std::function<void(Surgeon&)> swapSlots(size_t page, size_t a, size_t b) {
  return [=](Surgeon& s) {
    PackedBox first, second;
    s.editBox(page, a, [&](PackedBox& box) { first = box; });
    s.editBox(page, b, [&](PackedBox& box) { second = box, box = first; });
    s.editBox(page, a, [&](PackedBox& box) { box = second; });
  };
}
std::function<void(Surgeon&)> inHidden(int channel, uint16_t half) {
  return inBox(kPage, 3, [=](PackedBox& b) { b.energy[channel] = half; });
}

const std::vector<Case> kMapCases = {
    {"aMapTooFew", visibilityMaps, resizeMaps(-1024), kSplit},
    {"aMapTooMany", visibilityMaps, resizeMaps(1024), kSplit},
    {"halfAMap", chunkSize, resizeMaps(-512), kSplit},
    {"mapsGone", visibilityMaps, [](Surgeon& s) { s.removeChunk(chunk::kVisibilityMaps); }, kSplit},
    {"mapsEmpty", visibilityMaps, [](Surgeon& s) { s.setChunk(chunk::kVisibilityMaps, {}); }, kSplit},
    {"mapsTwice", chunkDuplicate, [](Surgeon& s) { s.addChunk(chunk::kVisibilityMaps, Bytes(3072)); },
     kSplit},
    {"mapsPaged", chunkCodec, inEntry(chunk::kVisibilityMaps, [](ChunkEntry& e) { e.codec = Codec::pages; }),
     kSplit},
    {"mapsHash", chunkHash, inEntry(chunk::kVisibilityMaps, [](ChunkEntry& e) { e.hash ^= 1; }), kSplit},
    {"mapsOfASketch", visibilityMaps, [](Surgeon& s) { s.addChunk(chunk::kVisibilityMaps, Bytes(1024)); },
     kSketch},
    {"flagWithoutScheme", visibilityMaps, [](Surgeon& s) { s.header.scheme = Scheme::sketch; }, kSplit},
    {"flagWithoutMap", visibilityMaps, inFlags(1, [](uint32_t& flags) { flags |= kSplitLobe; }), kSplit},
    {"flagInASketch", visibilityMaps, inFlags(1, [](uint32_t& flags) { flags |= kSplitLobe; }), kSketch},
    {"mapWithoutFlag", visibilityMaps, inFlags(0, [](uint32_t& flags) { flags = 0; }), kSplit},
};

const std::vector<Case> kHiddenCases = {
    {"hiddenMissing", hiddenPart, toBox(kPage, 3), kSplit},
    {"hiddenMissingBehindEmission", hiddenPart, toBox(kEmittedPage, 1), kSplit},
    {"hiddenTwice", hiddenPart, toHidden(kPage, 5), kSplit},
    {"hiddenInSlot1", hiddenPart, swapSlots(kPage, 3, 4), kSplit},
    {"hiddenInSlot2BehindEmission", hiddenPart, swapSlots(kEmittedPage, 1, 2), kSplit},
    {"hiddenBeforeEmission", boxKind, swapSlots(kEmittedPage, 0, 1), kSplit},
    {"hiddenOfAWholeRecord", hiddenPart, toHidden(kMixedPage, 0), kSplit},
    {"hiddenOfTheRecordBefore", hiddenPart, swapSlots(kMixedPage, 0, 3), kSplit},
    {"hiddenOfALambertKernel", hiddenPart, toHidden(kLambertPage, 0), kSplit},
    {"hiddenInASketch", hiddenPart, toHidden(kPage, 0), kSketch},
    {"flagsExchanged", hiddenPart,
     [](Surgeon& s) {
       inFlags(0, [](uint32_t& flags) { flags &= ~kSplitLobe; })(s);
       inFlags(1, [](uint32_t& flags) { flags |= kSplitLobe; })(s);
     },
     kSplit},
    {"hiddenNegative", boxEnergy, inHidden(0, 0xBC00), kSplit},
    {"hiddenInfinite", boxEnergy, inHidden(0, 0x7C00), kSplit},
    {"hiddenNan", boxEnergy, inHidden(0, 0x7E00), kSplit},
    {"hiddenNanInG", boxEnergy, inHidden(1, 0x7E00), kSplit},
    {"cosineInAView", boxKind,
     inBox(kPage, 4,
           [](PackedBox& b) {
             b = packCosineBox({{0, 0, 1, 1}, 1});
           }),
     kSplit},
    {"unknownKindInSlot0", boxKind, inBox(kPage, 3, [](PackedBox& b) { b.kind = 4; }), kSplit},
};

const std::vector<Case> kHarmless = {
    {"boxesBesideHidden", kernelEnergy, inBox(kPage, 4, [](PackedBox& b) { b.energy[0] = 0x4900; }), kSplit},
    {"unknownRecordFlag", reserved, inFlags(0, [](uint32_t& flags) { flags |= 32; }), kSplit},
};

INSTANTIATE_TEST_SUITE_P(Maps, Hostile, ::testing::ValuesIn(kMapCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(Hidden, Hostile, ::testing::ValuesIn(kHiddenCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(Split, Harmless, ::testing::ValuesIn(kHarmless), kCaseName);

Validation afterwards(const std::function<void(Surgeon&)>& operate) {
  return validationAfter(kSplit, operate);
}

TEST(Split, AHiddenPartIsNoEnergyOfAKernel) { EXPECT_TRUE(afterwards(inHidden(0, 0x7BFF)).count.empty()); }

TEST(Split, AHiddenPartMeansNothingByItsEdges) {
  EXPECT_TRUE(afterwards(inBox(kPage, 3, [](PackedBox& b) { b.v0 = b.dv = 65535; })).count.empty());
}

TEST(Split, NothingIsSaidOfFlagsIfTheMapsAreUnreadable) {
  const Validation validation = afterwards([](Surgeon& s) { s.entry(chunk::kVisibilityMaps).hash ^= 1; });
  EXPECT_EQ(validation.count.size(), 1u);
  EXPECT_TRUE(validation.count.contains(chunkHash));
}

TEST(Split, EveryKernelIsLookedAt) {
  const Validation validation = afterwards([](Surgeon& s) {
    for (const size_t box : {0, 3}) toBox(kPage, box)(s);
    toHidden(kMixedPage, 1)(s);
  });
  EXPECT_EQ(validation.count.at(hiddenPart), 3u);
}

}  // namespace
}  // namespace boxlight::asset
