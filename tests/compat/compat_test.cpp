// SPDX-License-Identifier: Apache-2.0
// Files of every released version of the format are kept for ever and must keep reading as they did.
#include <gtest/gtest.h>

#include "common/asset/asset_validate.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight::asset {
namespace {

TEST(Compatibility, version_1_0) {
  const std::filesystem::path path = GOLDEN_FOLDER "/version-1.0.ptb";
  EXPECT_EQ(contentHash(path), 0xe9acc4d4c205abbdull);
  const Validation validation = validateAsset(path);
  for (const Finding& finding : validation.findings) ADD_FAILURE() << finding.message();
  const AssetReader reader(path);
  EXPECT_EQ(reader.asset().provenance["tool"], "sample 1.0");
  EXPECT_EQ(reader.asset().records[4].atlasX, 4u);
  EXPECT_EQ(reader.page(12, 1).size(), 8u);
}

}  // namespace
}  // namespace boxlight::asset
