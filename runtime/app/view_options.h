// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/base/cli.h"
#include "runtime/app/settings.h"

namespace boxlight::gpu {

/// The command line of ptview.
struct ViewOptions {
  CommonOptions common;
  std::filesystem::path asset, environment, output, stats;
  std::filesystem::path truth, truthScene;  ///< of the window's split screen
  std::filesystem::path captures = ".";     ///< where the window writes pictures and settings
  ViewSettings settings;
  bool headless = false, listDevices = false, listKeys = false, validation = false;
  uint32_t frames = 1, firstFrame = 1;
  std::string device;
};

void addViewOptions(CLI::App& app, ViewOptions& options);

/// What the parser cannot say: options that need each other. Errors: ExitCode::usage.
void checkViewOptions(const ViewOptions& options);

}  // namespace boxlight::gpu
