// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "common/base/math.h"
#include "common/base/progress.h"

namespace boxlight {

/// What every command takes.
struct CommonOptions {
  int threads = 0;  ///< 0 = all
  bool quiet = false, verbose = false;
  ProgressStyle progress = ProgressStyle::automatic;
  bool json = false;  ///< results on stdout as JSON
};

void addCommonOptions(CLI::App& command, CommonOptions& options);

/// Option types that CLI11 does not know: "x,y,z" and "WxH". They throw CLI::ValidationError.
CLI::Option* addVec3(CLI::App& command, const std::string& name, vec3& value, const std::string& help);
CLI::Option* addVec3(CLI::App& command, const std::string& name, std::optional<vec3>& value,
                     const std::string& help);
CLI::Option* addSize(CLI::App& command, const std::string& name, uvec2& value, const std::string& help);
CLI::Option* addSize(CLI::App& command, const std::string& name, std::optional<uvec2>& value,
                     const std::string& help);

CLI::Option* addOnOff(CLI::App& command, const std::string& name, bool& value,
                      const std::string& help);  ///< "on" or "off"

/// A check for a number in [low, high]. Unlike CLI::Range it refuses NaN.
CLI::Validator inRange(double low, double high);

/// The number of threads that `--threads` means: all of them for 0.
int resolveThreads(int threads);

/// Parses argv into `app`, which calls the callback of the subcommand that was chosen, then `run`. Every
/// exception ends here: usage errors are exit 1, Error its own code, --help and --version exit 0 on stdout.
/// `options` sets the log up before them.
int runMain(CLI::App& app, int argc, char** argv, const CommonOptions& options,
            const std::function<void()>& run);

}  // namespace boxlight
