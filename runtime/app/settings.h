// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "common/image/camera.h"
#include "common/image/tone_map.h"
#include "common/light/environment_tilt.h"
#include "common/light/relight.h"
#include "runtime/app/frame.h"

namespace boxlight::gpu {

/// Everything a picture of an asset under an environment depends on: what the command line sets, the window
/// changes, and settings files hold. The same settings give the same picture in both.
struct ViewSettings {
  CameraOptions camera;  ///< its size is the picture's; in the window, the framebuffer's
  float environmentDegrees = 0;
  EnvironmentTilt environmentTilt;
  float environmentIntensity = 1;
  float exposure = 0;  ///< EV, of what is displayed
  ToneMap toneMap = ToneMap::none;
  bool background = true;
  uint32_t samples = 2;  ///< each way
  uint32_t boxes = 0;    ///< of each kernel; 0 = all
  uint32_t layers = 8;
  Interpolation interpolation = Interpolation::energy;
  std::optional<uvec2> lightSize;  ///< none: by the asset and the environment
  SatScheme satScheme = SatScheme::compact;
};

/// Completed for an asset's bounds, and with `lightSize` where the settings leave it open. Errors: those of
/// makeCamera.
FrameSettings frameSettings(const ViewSettings& settings, const asset::Info& info, uvec2 lightSize,
                            int threads);

}  // namespace boxlight::gpu
