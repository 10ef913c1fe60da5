// SPDX-License-Identifier: Apache-2.0
// What format 1.6 added, with values that no writer would write.
#include "tests/unit/asset/hostile.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

// 92 views, of which record n has those of sphere n mod 3: 92, 42 or 12. The last two of the nine records are
// of level 1, whose texels 0 and 1 show them; the atlas is 6 x 5, level 1 is 3 x 2.
constexpr SampleSize kCoarse{.viewFrequency = 3, .records = 9, .split = true, .coarse = true};
constexpr SampleSize kCells{.viewFrequency = 3, .records = 9, .split = true, .cells = true};
constexpr SampleSize kSketch{};

std::function<void(Surgeon&)> toSphere(size_t entry, uint32_t frequency, uint32_t count) {
  return in<GeodesicSphere>(chunk::kCoarseViews, entry, [=](GeodesicSphere& sphere) {
    sphere = {frequency, count};
  });
}
std::function<void(Surgeon&)> toViews(size_t record, uint32_t sphere) {
  return inFlags(record, [=](uint32_t& flags) {
    flags = (flags & ~uint32_t(kViewSphereBits)) | sphere << kViewSphereShift;
  });
}
/// Of a stream of three tiles.
std::function<void(Surgeon&)> inMask(size_t stream, size_t tile, uint64_t bits) {
  return in<uint64_t>(chunk::kStreamMasks, 3 * stream + tile, [=](uint64_t& mask) { mask |= bits; });
}
std::function<void(Surgeon&)> inRecord(size_t record, std::function<void(TexelRecord&)> change) {
  return in<TexelRecord>(chunk::kRecords, record, change);
}
std::function<void(Surgeon&)> inTexel(uint32_t type, size_t texel, std::function<void(AtlasTexel&)> change) {
  return in<AtlasTexel>(type, texel, change);
}
void addFour(Surgeon& s) {
  const std::array<GeodesicSphere, 4> spheres = {{{5, 252}, {4, 162}, {2, 42}, {1, 12}}};
  s.removeChunk(chunk::kCoarseViews);
  const auto bytes = std::as_bytes(std::span(spheres));
  s.addChunk(chunk::kCoarseViews, Bytes(bytes.begin(), bytes.end()));
}

const std::vector<Case> kViewCases = {
    {"viewGone", coarseViews, [](Surgeon& s) { s.removeChunk(chunk::kCoarseViews); }, kCoarse},
    {"viewEmpty", coarseViews, resizeTable(chunk::kCoarseViews, 0), kCoarse},
    {"halfASphere", chunkSize, resizeTable(chunk::kCoarseViews, 12), kCoarse},
    {"oneGone", coarseViews, resizeTable(chunk::kCoarseViews, 8), kCoarse},
    {"zeros", coarseViews, resizeTable(chunk::kCoarseViews, 24), kCoarse},
    {"millions", coarseViews, resizeTable(chunk::kCoarseViews, 8 << 20), kCoarse},
    {"four", coarseViews, addFour, kCoarse},
    {"asFineAsInfo", coarseViews, toSphere(0, 3, 92), kCoarse},
    {"finerThanInfo", coarseViews, toSphere(0, 4, 162), kCoarse},
    {"asFineAsTheOneBefore", coarseViews, toSphere(1, 2, 42), kCoarse},
    {"frequencyZero", coarseViews, toSphere(1, 0, 2), kCoarse},
    {"frequencyTop", coarseViews, toSphere(0, 0xFFFFFFFFu, 12), kCoarse},
    {"frequencyWraps", coarseViews, toSphere(0, 65536, 2), kCoarse},
    {"countZero", coarseViews, toSphere(0, 2, 0), kCoarse},
    {"countTop", coarseViews, toSphere(0, 2, 0xFFFFFFFFu), kCoarse},
    {"hash", chunkHash, inEntry(chunk::kCoarseViews, [](ChunkEntry& e) { e.hash ^= 1; }), kCoarse},
    {"paged", chunkCodec, inEntry(chunk::kCoarseViews, [](ChunkEntry& e) { e.codec = Codec::planes; }),
     kCoarse},
    {"numberOfNone", coarseViews, toViews(0, 3), kCoarse},
    {"numberInASketch", coarseViews, toViews(0, 1), kSketch},
    {"besideCells", coarseViews, toViews(0, 1), kCells},
    {"viewsThatItDoesNotHave", maskBits, toViews(0, 2), kCoarse},
    {"maskBehindThe42", maskBits, inMask(42, 0, 2), kCoarse},
    {"maskBehindThe12", maskBits, inMask(12, 0, 4), kCoarse},
};

const std::vector<Case> kLevelCases = {
    {"levelsGone", atlasLevels, [](Surgeon& s) { s.removeChunk(chunk::kAtlasLevels); }, kCoarse},
    {"aTexelLess", atlasLevels, resizeTable(chunk::kAtlasLevels, 5 * 8), kCoarse},
    {"aTexelMore", atlasLevels, resizeTable(chunk::kAtlasLevels, 8 * 8), kCoarse},
    {"halfATexel", chunkSize, resizeTable(chunk::kAtlasLevels, 44), kCoarse},
    {"beyondOneTexel", atlasLevels, resizeTable(chunk::kAtlasLevels, (6 + 1 + 1) * 8), kCoarse},
    {"millions", atlasLevels, resizeTable(chunk::kAtlasLevels, 8 << 20), kCoarse},
    {"hash", chunkHash, inEntry(chunk::kAtlasLevels, [](ChunkEntry& e) { e.hash ^= 1; }), kCoarse},
    {"recordOfNoLevel", atlasLevels, inRecord(8, [](TexelRecord& r) { r.level = 2; }), kCoarse},
    {"recordOfTheTopLevel", atlasLevels, inRecord(8, [](TexelRecord& r) { r.level = 0xFFFFFFFFu; }), kCoarse},
    {"levelInAnAtlasWithout", atlasLevels, inRecord(0, [](TexelRecord& r) { r.level = 1; }), kSketch},
    {"outsideItsLevel", recordTexel, inRecord(8, [](TexelRecord& r) { r.atlasX = 3; }), kCoarse},
    {"belowItsLevel", recordTexel, inRecord(8, [](TexelRecord& r) { r.atlasY = 2; }), kCoarse},
    {"fineShowsCoarse", atlasLevels, inTexel(chunk::kAtlas, 0, [](AtlasTexel& t) { t.front = 7; }), kCoarse},
    {"coarseShowsFine", atlasLevels, inTexel(chunk::kAtlasLevels, 0, [](AtlasTexel& t) { t.front = 0; }),
     kCoarse},
    {"coarseShowsNone", atlasRecord, inTexel(chunk::kAtlasLevels, 5, [](AtlasTexel& t) { t.back = 9; }),
     kCoarse},
    {"coarseShowsTheOtherSide", atlasRecord,
     inTexel(chunk::kAtlasLevels, 0, [](AtlasTexel& t) { std::swap(t.front, t.back); }), kCoarse},
};

INSTANTIATE_TEST_SUITE_P(CoarseViews, Hostile, ::testing::ValuesIn(kViewCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(AtlasLevels, Hostile, ::testing::ValuesIn(kLevelCases), kCaseName);

TEST(AtlasLevels, AreCountedOnlyWhereTheyAreWhole) {
  Asset asset;
  asset.info.atlasWidth = 5, asset.info.atlasHeight = 3;
  for (const auto& [texels, levels] :
       std::vector<std::pair<size_t, uint32_t>>{{0, 1}, {2, 2}, {3, 3}, {1, 0}, {4, 0}}) {
    asset.atlasLevels.resize(texels);
    EXPECT_EQ(asset.levelCount(), levels) << texels;
  }
  asset.info.atlasWidth = asset.info.atlasHeight = 0xFFFFFFFFu;
  asset.atlasLevels.resize(3);
  EXPECT_EQ(asset.levelCount(), 0u);
}

}  // namespace
}  // namespace boxlight::asset
