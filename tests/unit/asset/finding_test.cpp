// SPDX-License-Identifier: Apache-2.0
#include "common/asset/finding.h"

#include <gtest/gtest.h>

#include <set>

#include "common/asset/asset_format.h"
#include "common/base/file.h"

namespace boxlight::asset {
namespace {

TEST(Findings, areInTheDocumentWordForWord) {
  const auto bytes = readFile(FORMAT_DOCUMENT);
  const std::string document(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::set<FindingCode> codes;
  for (const FindingKind& kind : findingKinds()) {
    EXPECT_TRUE(codes.insert(kind.code).second) << int(kind.code);
    const std::string row =
        fmt::format("| {} | {} | {} |", int(kind.code), severityName(kind.severity), kind.title);
    EXPECT_NE(document.find(row), std::string::npos) << row;
  }
}

TEST(Findings, onlyErrorsEndAReading) {
  const Reporter report = throwingReporter("a.ptb");
  EXPECT_NO_THROW(report(FindingCode::newerMinor, 0, "version", "1.7"));
  EXPECT_NO_THROW(report(FindingCode::bounds, fourCc("VERT"), "vertex 1", "outside"));
  EXPECT_THROW(report(FindingCode::counts, fourCc("VERT"), "", "3"), Error);
}

TEST(Findings, chunkNamesArePrintable) {
  EXPECT_EQ(Reporter::chunkName(fourCc("VERT")), "VERT");
  EXPECT_EQ(Reporter::chunkName(0x1B5B3001), "?0[?");
}

}  // namespace
}  // namespace boxlight::asset
