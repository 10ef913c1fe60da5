// SPDX-License-Identifier: Apache-2.0
// What format 1.3 added, with values that no writer would write.
#include "common/asset/asset_checks.h"
#include "tests/unit/asset/hostile.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

constexpr SampleSize kCells{.split = true, .cells = true}, kSplit{.split = true}, kSketch{};
constexpr SampleSize kNoTiles{.records = 0, .split = true, .cells = true};
// Of makeSample(kCells), with 12 views and the 42 cells of frequency 2, whose records 0, 2 and 3 are split
// and whose records 0 and 3 have cells, with the slots of their kernels:
constexpr size_t kViewPage = 0;      // record 2 in view 0
constexpr size_t kCellPage = 28;     // record 0 in cell 1: hidden part, two boxes
constexpr size_t kEmittedPage = 29;  // record 3 in cell 1: emitted radiance, hidden part, two boxes

std::function<void(Surgeon&)> toSphere(uint32_t frequency, uint32_t count) {
  return in<GeodesicSphere>(chunk::kCellSphere, 0, [=](GeodesicSphere& sphere) {
    sphere = {frequency, count};
  });
}
/// A sound sphere where none belongs.
void addSphere(Surgeon& s) {
  const GeodesicSphere sphere{2, 42};
  const auto bytes = std::as_bytes(std::span(&sphere, 1));
  s.addChunk(chunk::kCellSphere, Bytes(bytes.begin(), bytes.end()));
}
std::function<void(Surgeon&)> toScheme(Scheme scheme) {
  return [=](Surgeon& s) { s.header.scheme = scheme; };
}
std::function<void(Surgeon&)> inMask(size_t page, uint64_t bits) {
  return in<uint64_t>(chunk::kStreamMasks, page, [=](uint64_t& mask) { mask |= bits; });
}
void setCells(uint32_t& flags) { flags |= kDirectionCells; }
void clearCells(uint32_t& flags) { flags &= ~uint32_t(kDirectionCells); }

const std::vector<Case> kSphereCases = {
    {"sphereGone", directionCells, [](Surgeon& s) { s.removeChunk(chunk::kCellSphere); }, kCells},
    {"sphereEmpty", directionCells, resizeTable(chunk::kCellSphere, 0), kCells},
    {"twoSpheres", directionCells, resizeTable(chunk::kCellSphere, 16), kCells},
    {"manySpheres", directionCells, resizeTable(chunk::kCellSphere, 1 << 20), kCells},
    {"halfASphere", chunkSize, resizeTable(chunk::kCellSphere, 4), kCells},
    {"chunkTwice", chunkDuplicate, addSphere, kCells},
    {"spherePaged", chunkCodec, inEntry(chunk::kCellSphere, [](ChunkEntry& e) { e.codec = Codec::pages; }),
     kCells},
    {"sphereHash", chunkHash, inEntry(chunk::kCellSphere, [](ChunkEntry& e) { e.hash ^= 1; }), kCells},
    {"frequencyZero", directionCells, toSphere(0, 2), kCells},
    {"frequencyAboveTheLimit", directionCells, toSphere(17, 2892), kCells},
    {"frequencyWraps", directionCells, toSphere(65536, 2), kCells},
    {"frequencyTop", directionCells, toSphere(0xFFFFFFFFu, 12), kCells},
    {"countZero", directionCells, toSphere(2, 0), kCells},
    {"countOneMore", directionCells, toSphere(2, 43), kCells},
    {"countTop", directionCells, toSphere(2, 0xFFFFFFFFu), kCells},
    {"countWrapsToNoStreams", directionCells, toSphere(2, 0u - 13), kCells},
    {"countTopWithoutTiles", directionCells, toSphere(2, 0xFFFFFFFFu - 13), kNoTiles},
    {"sphereOfOthers", counts, toSphere(3, 92), kCells},
    {"masksOfASplit", counts, resizeTable(chunk::kStreamMasks, 26 * sizeof(uint64_t)), kCells},
    {"pagesOfASplit", counts, resizeTable(chunk::kPageIndex, 26 * sizeof(PageEntry)), kCells},
    {"schemeSplit", directionCells, toScheme(Scheme::split), kCells},
    {"schemeSketch", directionCells, toScheme(Scheme::sketch), kCells},
    {"schemeSplitWithoutTiles", directionCells, toScheme(Scheme::split), kNoTiles},
    {"sphereInASplit", directionCells, addSphere, kSplit},
    {"sphereInASketch", directionCells, addSphere, kSketch},
    {"schemeWithoutSphere", directionCells, toScheme(Scheme::cells), kSplit},
};

const std::vector<Case> kFlagCases = {
    {"flagInASplit", directionCells, inFlags(2, setCells), kSplit},
    {"flagInASketch", directionCells, inFlags(2, setCells), kSketch},
    {"flagOfAWholeRecord", directionCells, inFlags(1, setCells), kCells},
    {"flagAlone", directionCells, inFlags(0, [](uint32_t& flags) { flags = kDirectionCells; }), kCells},
    {"flagLost", maskBits, inFlags(0, clearCells), kCells},
    {"flagGained", maskBits, inFlags(2, setCells), kCells},
};

const std::vector<Case> kKernelCases = {
    {"viewOfARecordWithCells", maskBits, inMask(kViewPage, 1), kCells},
    {"cellOfASplitRecordWithout", maskBits, inMask(kCellPage, 4), kCells},
    {"cellOfAWholeRecord", maskBits, inMask(kCellPage, 2), kCells},
    {"cellBeyondTheTile", maskBits, inMask(kCellPage, uint64_t(1) << 63), kCells},
    {"hiddenMissing", hiddenPart, toBox(kCellPage, 0), kCells},
    {"hiddenMissingBehindEmission", hiddenPart, toBox(kEmittedPage, 1), kCells},
    {"hiddenTwice", hiddenPart, toHidden(kCellPage, 2), kCells},
    {"cellWithoutTheEmissionOfViews", emittedSlots,
     [](Surgeon& s) { toHidden(kEmittedPage, 0)(s), toBox(kEmittedPage, 1)(s); }, kCells},
    {"pageTooLong", pageSize,
     in<PageEntry>(chunk::kPageIndex, kCellPage, [](PageEntry& p) { p.rawSize += 16; }), kCells},
    {"pageHash", pageHash, in<PageEntry>(chunk::kPageIndex, kCellPage, [](PageEntry& p) { p.hash ^= 1; }),
     kCells},
};

INSTANTIATE_TEST_SUITE_P(CellSphere, Hostile, ::testing::ValuesIn(kSphereCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(CellFlags, Hostile, ::testing::ValuesIn(kFlagCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(CellKernels, Hostile, ::testing::ValuesIn(kKernelCases), kCaseName);

Validation afterwards(const std::function<void(Surgeon&)>& operate) {
  return validationAfter(kCells, operate);
}

TEST(Cells, NothingIsSaidOfStreamsIfTheSphereIsUnreadable) {
  const Validation validation = afterwards([](Surgeon& s) { s.entry(chunk::kCellSphere).hash ^= 1; });
  EXPECT_EQ(validation.count.size(), 1u);
  EXPECT_TRUE(validation.count.contains(chunkHash));
}

TEST(Cells, NothingIsSaidOfMasksIfTheRecordsAreUnreadable) {
  const Validation validation = afterwards([](Surgeon& s) { s.entry(chunk::kRecords).hash ^= 1; });
  EXPECT_EQ(validation.count.size(), 1u);
  EXPECT_TRUE(validation.count.contains(chunkHash));
}

TEST(Cells, NothingIsSaidOfStreamsThatCannotBeCounted) {
  const Validation validation = afterwards(toSphere(2, 0xFFFFFFFFu));
  EXPECT_EQ(validation.count.size(), 1u);
  EXPECT_EQ(validation.count.at(directionCells), 1u);
}

TEST(Cells, PlacesNameTheCell) {
  const Validation validation = afterwards(toBox(kEmittedPage, 1));
  ASSERT_EQ(validation.findings.size(), 1u);
  EXPECT_EQ(validation.findings[0].place, "cell 1, tile 1, record 3");
}

/// Without tiles, tables of any number of streams are empty: a wrong number must not be counted to.
TEST(Cells, PagesAreLookedForIfTheStreamsCanBeCounted) {
  LoadedAsset loaded{.asset = makeSample(kNoTiles).asset};
  loaded.present.add(chunk::kInfo);
  loaded.present.add(chunk::kPageIndex);
  loaded.present.add(chunk::kPages);
  forEachTable(loaded.asset, [&](uint32_t type, const auto&) { loaded.present.add(type); });
  EXPECT_TRUE(pagesCanBeFound(loaded));
  LoadedAsset views = loaded, cells = loaded, spheres = loaded, scheme = loaded;
  views.asset.info.viewCount = 0xFFFFFFFFu - 43;
  cells.asset.cellSphere[0].count = 0xFFFFFFFFu - 13;
  spheres.asset.cellSphere.push_back({2, 42});
  scheme.asset.scheme = Scheme::split;
  for (const LoadedAsset* wrong : {&views, &cells, &spheres, &scheme}) EXPECT_FALSE(pagesCanBeFound(*wrong));
}

}  // namespace
}  // namespace boxlight::asset
