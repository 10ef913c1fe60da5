// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "common/asset/finding.h"

namespace boxlight::asset {

struct Validation {
  std::vector<Finding> findings;          ///< the first kShownPerCode of each code, in the order of the file
  std::map<FindingCode, uint64_t> count;  ///< how often each code was found

  uint64_t total(Severity severity) const;
  /// ok without errors; unsupported if every error is of that kind; else invalidInput.
  ExitCode exitCode() const;
};

inline constexpr uint64_t kShownPerCode = 10;

/// Reads the whole file, every page included, and goes on after what it finds as far as that makes sense.
/// Error: ExitCode::io if the file cannot be read.
Validation validateAsset(const std::filesystem::path& path);

}  // namespace boxlight::asset
