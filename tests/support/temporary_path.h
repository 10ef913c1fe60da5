// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace boxlight::test {

/// A path for this process alone, so that suites of several builds and users can run side by side.
inline std::filesystem::path temporaryPath(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("boxlight-" + std::to_string(::getpid()) + "-" + name);
}

}  // namespace boxlight::test
