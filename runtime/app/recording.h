// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/app/settings.h"

namespace boxlight::gpu {

struct RecordingOptions {
  int frames = 120;  ///< of a turntable, or of a whole flight
  bool exr = false;  ///< else PNG
};

/// Once around the target, `frames` cameras an equal angle apart; the one after the last is the first.
std::vector<CameraOptions> turntableCameras(const CameraOptions& camera, int frames);
/// Along a path of at least two cameras, ends included.
std::vector<CameraOptions> flightCameras(const std::vector<CameraOptions>& path, int frames);

/// A row of pictures in a folder of its own: STEM-NNN/frame-0001.png and on.
class Recording {
 public:
  /// Makes the folder. Error: ExitCode::io.
  Recording(const std::filesystem::path& captures, const char* stem, std::vector<CameraOptions> cameras,
            bool exr);

  bool done() const { return next_ == cameras_.size(); }
  const CameraOptions& camera() const { return cameras_[next_]; }  ///< of the frame to write next
  void write(const Image& picture, const ViewSettings& settings);
  size_t written() const { return next_; }
  size_t frames() const { return cameras_.size(); }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::vector<CameraOptions> cameras_;
  bool exr_;
  size_t next_ = 0;
};

/// The first of STEM-001EXTENSION, STEM-002EXTENSION, ... that is not there yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const char* stem, const char* extension);

/// Linear as .exr; as .png what the settings display. Errors: those of writeImage.
void writePicture(const std::filesystem::path& path, const Image& picture, const ViewSettings& settings);

}  // namespace boxlight::gpu
