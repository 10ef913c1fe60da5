// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <thread>

#include "common/asset/asset_load.h"
#include "common/asset/asset_validate.h"
#include "common/base/file.h"
#include "tests/format/sample_asset.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight::asset {
namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSame(const Sample& sample, const AssetReader& reader) {
  const Asset &written = sample.asset, &read = reader.asset();
  EXPECT_EQ(written.scheme, read.scheme);
  EXPECT_EQ(written.provenance, read.provenance);
  EXPECT_EQ(written.info.viewCount, read.info.viewCount);
  EXPECT_EQ(written.info.atlasWidth, read.info.atlasWidth);
  EXPECT_EQ(read.info.vertexCount, written.vertices.size());
  EXPECT_EQ(read.info.tileCount, written.tiles.size());
  EXPECT_TRUE(sameBytes(written.vertices, read.vertices));
  EXPECT_TRUE(sameBytes(written.triangles, read.triangles));
  EXPECT_TRUE(sameBytes(written.materials, read.materials));
  EXPECT_TRUE(sameBytes(written.materialExtensions, read.materialExtensions));
  EXPECT_TRUE(sameBytes(written.textureTransforms, read.textureTransforms));
  EXPECT_TRUE(sameBytes(written.textures, read.textures));
  EXPECT_TRUE(sameBytes(written.texels, read.texels));
  EXPECT_TRUE(sameBytes(written.atlas, read.atlas));
  EXPECT_TRUE(sameBytes(written.records, read.records));
  EXPECT_TRUE(sameBytes(written.tiles, read.tiles));
  EXPECT_TRUE(sameBytes(written.visibilityMaps, read.visibilityMaps));
  EXPECT_TRUE(sameBytes(written.cellSphere, read.cellSphere));
  EXPECT_TRUE(sameBytes(written.coarseViews, read.coarseViews));
  EXPECT_TRUE(sameBytes(written.atlasLevels, read.atlasLevels));
  EXPECT_TRUE(sameBytes(written.streamMasks, read.streamMasks));
  for (uint32_t stream = 0; stream < read.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < read.tiles.size(); ++tile)
      EXPECT_TRUE(
          sameBytes(sample.pages[size_t(stream) * read.tiles.size() + tile], reader.page(stream, tile)));
}

class RoundTrip : public ::testing::TestWithParam<SampleSize> {};

TEST_P(RoundTrip, everyValueComesBack) {
  const Sample sample = makeSample(GetParam());
  const TemporaryFile file;
  sample.write(file.path);
  expectSame(sample, AssetReader(file.path));
  const Validation validation = validateAsset(file.path);
  for (const Finding& finding : validation.findings) ADD_FAILURE() << finding.message();
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, RoundTrip,
    ::testing::Values(
        SampleSize{}, SampleSize{.viewFrequency = 3, .records = 70, .recordsPerTile = 64},
        SampleSize{.records = 64, .recordsPerTile = 64}, SampleSize{.records = 0},
        SampleSize{.extensions = false}, SampleSize{.split = true},
        SampleSize{.extensions = false, .split = true},
        SampleSize{.viewFrequency = 2, .records = 70, .recordsPerTile = 64, .split = true},
        SampleSize{.split = true, .cells = true}, SampleSize{.cosine = true},
        SampleSize{.extensions = false, .split = true, .cells = true},
        SampleSize{.records = 0, .split = true, .cells = true},
        SampleSize{.viewFrequency = 3, .split = true, .coarse = true},
        SampleSize{.viewFrequency = 3, .records = 150, .recordsPerTile = 64, .coarse = true},
        SampleSize{.viewFrequency = 2, .records = 70, .recordsPerTile = 64, .split = true, .cells = true}));

TEST(RoundTrip, theSampleHasSplitRecordsWithEmissionAndWithout) {
  const Sample sample = makeSample({.split = true});
  size_t split = 0, withEmission = 0;
  for (const std::vector<PackedBox>& page : sample.pages)
    for (size_t i = 0; i < page.size(); ++i) {
      split += isHiddenPart(page[i]);
      withEmission += i > 0 && isHiddenPart(page[i]) && isEmission(page[i - 1]);
    }
  EXPECT_EQ(sample.asset.visibilityMaps.size(), 3u);
  EXPECT_GT(withEmission, 0u);
  EXPECT_GT(split, withEmission);
}

TEST(RoundTrip, theSampleHasCellsWithEmissionAndWithoutAndCellsThatAreAbsent) {
  const Sample sample = makeSample({.split = true, .cells = true});
  const Asset& asset = sample.asset;
  ASSERT_EQ(asset.streamCount(), 12u + 1 + 42);
  size_t plain = 0, withEmission = 0, absent = 0;
  for (uint32_t stream = asset.firstCellStream(); stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) {
      const std::vector<PackedBox>& page = sample.pages[stream * asset.tiles.size() + tile];
      absent += page.empty();
      withEmission += page.size() > 1 && isEmission(page[0]) && isHiddenPart(page[1]);
      plain += !page.empty() && isHiddenPart(page[0]);
    }
  EXPECT_GT(plain, 0u);
  EXPECT_GT(withEmission, 0u);
  EXPECT_GT(absent, 0u);
}

TEST(AssetWriter, leavesOutTheOptionalTablesThatAreEmpty) {
  const auto typesOf = [](const SampleSize& size) {
    const TemporaryFile file;
    makeSample(size).write(file.path);
    const AssetReader reader(file.path);
    std::vector<std::string> types;
    for (const ChunkEntry& entry : reader.chunks()) types.push_back(Reporter::chunkName(entry.type));
    return types;
  };
  using Types = std::vector<std::string>;
  EXPECT_EQ(typesOf({.extensions = false}), (Types{"PROV", "INFO", "VERT", "TRIS", "MATL", "TEXI", "TEXD",
                                                   "ATLS", "RECS", "TILE", "MASK", "PAGE", "PGIX"}))
      << "those of version 1.0, in its order";
  EXPECT_EQ(typesOf({}), (Types{"PROV", "INFO", "VERT", "TRIS", "MATL", "MATX", "TXFM", "TEXI", "TEXD",
                                "ATLS", "RECS", "TILE", "MASK", "PAGE", "PGIX"}));
  EXPECT_EQ(typesOf({.extensions = false, .split = true}),
            (Types{"PROV", "INFO", "VERT", "TRIS", "MATL", "TEXI", "TEXD", "ATLS", "RECS", "TILE", "VISI",
                   "MASK", "PAGE", "PGIX"}));
  EXPECT_EQ(typesOf({.extensions = false, .split = true, .cells = true}),
            (Types{"PROV", "INFO", "VERT", "TRIS", "MATL", "TEXI", "TEXD", "ATLS", "RECS", "TILE", "VISI",
                   "CELL", "MASK", "PAGE", "PGIX"}));
}

TEST(AssetWriter, givesTheSameBytesForTheSameInput) {
  const TemporaryFile first, second;
  makeSample({.records = 200}).write(first.path);
  makeSample({.records = 200}).write(second.path);
  EXPECT_EQ(readFile(first.path), readFile(second.path));
}

TEST(AssetWriter, asksForPagesStreamMajorAndOnlyForThoseThatExist) {
  const Sample sample = makeSample();
  std::vector<std::pair<uint32_t, uint32_t>> asked, expected;
  for (uint32_t stream = 0; stream < sample.asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < sample.asset.tiles.size(); ++tile)
      if (sample.asset.mask(stream, tile) != 0) expected.emplace_back(stream, tile);
  const TemporaryFile file;
  writeAsset(file.path, sample.asset, [&](uint32_t stream, uint32_t tile) {
    asked.emplace_back(stream, tile);
    return sample.source()(stream, tile);
  });
  EXPECT_EQ(asked, expected);
  EXPECT_LT(expected.size(), sample.asset.streamMasks.size());
}

Codec codecOfTexels(const Sample& sample) {
  const TemporaryFile file;
  sample.write(file.path);
  const AssetReader reader(file.path);
  Codec codec{};
  for (const ChunkEntry& entry : reader.chunks()) {
    EXPECT_EQ(entry.offset % 16, 0u);
    EXPECT_EQ(entry.codec == Codec::planes, entry.type == chunk::kPages);
    EXPECT_TRUE(isPaged(entry.codec) || entry.storedSize <= entry.rawSize);
    if (entry.type == chunk::kTexels) codec = entry.codec;
  }
  return codec;
}

TEST(AssetWriter, alignsChunksAndCompressesOnlyWhereItHelps) {
  Sample sample = makeSample();
  EXPECT_EQ(codecOfTexels(sample), Codec::none) << "random texels";
  sample.asset.texels.resize(1 << 16, 0x80808080u);
  EXPECT_EQ(codecOfTexels(sample), Codec::zstd) << "one colour";
}

TEST(AssetWriter, staysWithinTheExpansionLimit) {
  const TemporaryFile file;
  Sample sample = makeSample();
  sample.asset.texels.resize(kFreeExpansion / 4 + 1, 0);
  sample.write(file.path);
  EXPECT_EQ(AssetReader(file.path).asset().texels.size(), sample.asset.texels.size());
}

TEST(AssetWriter, refusesWhatTheReaderWouldRefuse) {
  const TemporaryFile file;
  const auto expectRefusal = [&](const Sample& sample) {
    try {
      sample.write(file.path);
      ADD_FAILURE() << "written";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::runtime) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(file.path));
  };
  Sample badIndex = makeSample(), badBox = makeSample(), shortPage = makeSample(),
         badProvenance = makeSample(), badExtension = makeSample(), viewsDisagree = makeSample(),
         flagsAlone = makeSample({.extensions = false}), aMapTooFew = makeSample({.split = true}),
         schemeOfSketch = aMapTooFew, noHiddenPart = aMapTooFew;
  badExtension.asset.materialExtensions.pop_back();
  viewsDisagree.pages[3][0] = PackedBox();
  flagsAlone.asset.materials[1].flags |= kUnlit;
  aMapTooFew.asset.visibilityMaps.pop_back();
  schemeOfSketch.asset.scheme = Scheme::sketch;
  noHiddenPart.pages[0][0].kind = kLightBox;
  badIndex.asset.triangles[1].vertex[2] = 7;
  badBox.pages[0][0].energy[1] = 0x7C00;
  shortPage.pages[0].pop_back();
  badProvenance.asset.provenance = nullptr;
  for (const Sample* sample : {&badIndex, &badBox, &shortPage, &badProvenance, &badExtension, &viewsDisagree,
                               &flagsAlone, &aMapTooFew, &schemeOfSketch, &noHiddenPart})
    expectRefusal(*sample);
}

TEST(AssetWriter, refusesCellsThatTheReaderWouldRefuse) {
  const Sample sound = makeSample({.split = true, .cells = true});
  const TemporaryFile file;
  const auto expectRefusal = [&](const char* what, const std::function<void(Sample&)>& change) {
    Sample sample = sound;
    change(sample);
    EXPECT_THROW(sample.write(file.path), Error) << what;
    EXPECT_FALSE(std::filesystem::exists(file.path)) << what;
  };
  expectRefusal("no sphere", [](Sample& s) { s.asset.cellSphere.clear(); });
  expectRefusal("two spheres", [](Sample& s) { s.asset.cellSphere.push_back({2, 42}); });
  expectRefusal("count", [](Sample& s) { s.asset.cellSphere[0].count = 0xFFFFFFFFu; });
  expectRefusal("scheme", [](Sample& s) { s.asset.scheme = Scheme::split; });
  expectRefusal("no split lobe", [](Sample& s) { s.asset.records[1].flags |= kDirectionCells; });
  expectRefusal("in views", [](Sample& s) { s.asset.records[2].flags |= kDirectionCells; });
  expectRefusal("in cells", [](Sample& s) { s.asset.records[0].flags &= ~uint32_t(kDirectionCells); });
  expectRefusal("masks", [](Sample& s) { s.asset.streamMasks.resize(13 * s.asset.tiles.size()); });
  expectRefusal("no hidden part", [](Sample& s) { s.pages[28][0].kind = kLightBox; });
  sound.write(file.path);
  EXPECT_TRUE(std::filesystem::exists(file.path));
}

TEST(AssetReader, readsPagesFromSeveralThreads) {
  const Sample sample = makeSample({.records = 70, .recordsPerTile = 7});
  const TemporaryFile file;
  sample.write(file.path);
  const AssetReader reader(file.path);
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&] { expectSame(sample, reader); });
}

TEST(AssetReader, saysWhatIsWrongWithThePath) {
  for (const char* path : {"/nonexistent/asset.ptb", "/", "/dev/null"}) try {
      AssetReader reader{path};
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::io);
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
}

}  // namespace
}  // namespace boxlight::asset
