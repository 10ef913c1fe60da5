// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/base/cli.h"
#include "common/image/camera.h"
#include "common/light/environment_tilt.h"
#include "common/light/relight.h"
#include "runtime/light/fixed_point.h"

namespace boxlight::gpu {

/// The command line of ptview.
struct ViewOptions {
  CommonOptions common;
  std::filesystem::path asset, environment, output, stats;
  CameraOptions camera;
  bool headless = false, listDevices = false, validation = false;
  float environmentDegrees = 0, environmentIntensity = 1, exposure = 0;
  EnvironmentTilt environmentTilt;
  bool background = true;
  uint32_t frames = 1, firstFrame = 1, samples = 2, boxes = 0, layers = 8;  ///< boxes 0 = all
  Interpolation interpolation = Interpolation::energy;
  std::optional<uvec2> lightSize;  ///< by the asset if there is none
  SatScheme satScheme = SatScheme::compact;
  std::string device;
};

void addViewOptions(CLI::App& app, ViewOptions& options);

/// What the parser cannot say: options that need each other. Errors: ExitCode::usage.
void checkViewOptions(const ViewOptions& options);

}  // namespace boxlight::gpu
