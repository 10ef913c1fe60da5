// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/app/recording.h"
#include "runtime/app/settings_json.h"

namespace boxlight::gpu {

/// A path-traced picture and the camera that it was made for.
struct Truth {
  Image picture;
  CameraOptions camera;
  std::string environment;
  float environmentDegrees = 0;
  EnvironmentTilt environmentTilt;
  float environmentIntensity = 1;
};

/// What the window knows, apart from how it is drawn: `file` is what is shown, and what is saved.
struct Session {
  SettingsFile file;
  CameraOptions startCamera;  ///< complete; where R goes
  bool flying = false, help = false, panel = true, openDialog = false;
  float flySpeed = 0;  ///< metres a second
  std::string message;
  std::optional<Truth> truth;
  bool split = false;
  float splitAt = 0.5f;  ///< of the window's width
  std::vector<CameraOptions> path;
  RecordingOptions recording;

  ViewSettings& settings() { return file.settings; }
  const ViewSettings& settings() const { return file.settings; }
  CameraOptions& camera() { return file.settings.camera; }
  /// Is there a truth of what is shown?
  bool truthFits() const;
};

}  // namespace boxlight::gpu
