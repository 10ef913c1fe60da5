// SPDX-License-Identifier: Apache-2.0
// Files of every released version of the format are kept for ever and must keep reading as they did.
#include <gtest/gtest.h>

#include "common/asset/asset_validate.h"
#include "tests/format/sample_asset.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight::asset {
namespace {

struct Version {
  const char* file;
  uint64_t contentHash;
  SampleSize sample;
  Codec pages = Codec::pages;
};

class Compatibility : public ::testing::TestWithParam<Version> {};

TEST_P(Compatibility, readsAsItDid) {
  const std::filesystem::path path = std::filesystem::path(GOLDEN_FOLDER) / GetParam().file;
  EXPECT_EQ(contentHash(path), GetParam().contentHash);
  const Validation validation = validateAsset(path);
  for (const Finding& finding : validation.findings) ADD_FAILURE() << finding.message();
  const AssetReader reader(path);
  EXPECT_EQ(reader.asset().provenance["tool"], "sample 1.0");
  for (const ChunkEntry& entry : reader.chunks())
    EXPECT_EQ(isPaged(entry.codec) ? entry.codec : GetParam().pages, GetParam().pages);
  const bool coarse = GetParam().sample.coarse;
  EXPECT_EQ(reader.asset().records[4].atlasX, coarse ? 1u : 4u);
  EXPECT_EQ(reader.asset().records[4].level, coarse ? 1u : 0u);
  EXPECT_EQ(reader.asset().coarseViews.size(), coarse ? 2u : 0u);
  EXPECT_EQ(reader.page(reader.asset().diffuseStream(), 1).size(), 8u);
  EXPECT_EQ(reader.asset().materialExtensions.empty(), !GetParam().sample.extensions);
  EXPECT_EQ(reader.asset().visibilityMaps.size(), GetParam().sample.split ? 3u : 0u);
  const bool cells = GetParam().sample.cells;
  EXPECT_EQ(reader.asset().cellCount(), cells ? 42u : 0u);
  EXPECT_EQ(isHiddenPart(reader.page(cells ? 14 : 2, 1)[1]), GetParam().sample.split)
      << "record 3, behind its emission, in view 2 or cell 1";
}

TEST_P(Compatibility, isWhatIsWrittenToday) {
  const TemporaryFile file;
  makeSample(GetParam().sample).write(file.path);
  EXPECT_EQ(contentHash(file.path), GetParam().contentHash);
}

INSTANTIATE_TEST_SUITE_P(
    Versions, Compatibility,
    ::testing::Values(Version{"version-1.0.ptb", 0xe9acc4d4c205abbdull, {.extensions = false}},
                      Version{"version-1.1.ptb", 0x2494a6ebac4d2b26ull, {}},
                      Version{"version-1.2.ptb", 0xe0cf0c3ba180b77aull, {.split = true}},
                      Version{"version-1.3.ptb", 0x5a174fe6224cc596ull, {.split = true, .cells = true}},
                      Version{"version-1.4.ptb", 0x708ee3641001e4ffull, {.cosine = true}},
                      Version{"version-1.5.ptb", 0x708ee3641001e4ffull, {.cosine = true}, Codec::planes},
                      Version{"version-1.6.ptb",
                              0x67e45237e105706ull,
                              {.viewFrequency = 3, .split = true, .cosine = true, .coarse = true},
                              Codec::planes}));

}  // namespace
}  // namespace boxlight::asset
