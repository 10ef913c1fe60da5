// SPDX-License-Identifier: Apache-2.0
// extremes_test [gtest options]: the tests.   extremes_test --table: prints the table of docs/numerics.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string_view>

#include "tests/extremes/light_report.h"

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--table") {
    boxlight::gpu::Device device({"", false});
    fmt::print("{}", boxlight::test::toMarkdown(boxlight::test::measureLight(device)));
    return 0;
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
