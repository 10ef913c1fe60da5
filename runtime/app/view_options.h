// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/base/cli.h"
#include "common/image/camera.h"
#include "common/light/relight.h"

namespace boxlight::gpu {

/// The command line of ptview.
struct ViewOptions {
  CommonOptions common;
  std::filesystem::path asset, environment, output, stats;
  CameraOptions camera;
  bool headless = false, listDevices = false, validation = false;
  float environmentDegrees = 0, exposure = 0;
  bool background = true;
  uint32_t frames = 1, samples = 2, boxes = 0, layers = 8;  ///< boxes 0 = all
  Interpolation interpolation = Interpolation::energy;
  uvec2 lightSize{512, 256};
  std::string device;
};

void addViewOptions(CLI::App& app, ViewOptions& options);

/// What the parser cannot say: options that need each other. Errors: ExitCode::usage.
void checkViewOptions(const ViewOptions& options);

}  // namespace boxlight::gpu
