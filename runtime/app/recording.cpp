// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/recording.h"

#include "common/base/error.h"
#include "runtime/app/camera_control.h"

namespace boxlight::gpu {
namespace {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail(ExitCode::io, "{}: cannot make the folder: {}", folder.string(), error.message());
}

}  // namespace

std::vector<CameraOptions> turntableCameras(const CameraOptions& camera, int frames) {
  std::vector<CameraOptions> cameras;
  for (int i = 0; i < frames; ++i) {
    cameras.push_back(camera);
    if (i > 0) orbit(cameras.back(), 360.0f * float(i) / float(frames), 0.0f);
  }
  return cameras;
}

std::vector<CameraOptions> flightCameras(const std::vector<CameraOptions>& path, int frames) {
  std::vector<CameraOptions> cameras;
  for (int i = 0; i < frames; ++i)
    cameras.push_back(cameraOnPath(path, float(i) / float(std::max(frames - 1, 1))));
  return cameras;
}

std::filesystem::path freeName(const std::filesystem::path& folder, const char* stem, const char* extension) {
  for (int i = 1;; ++i) {
    const auto path = folder / fmt::format("{}-{:03}{}", stem, i, extension);
    if (!std::filesystem::exists(path)) return path;
  }
}

void writePicture(const std::filesystem::path& path, const Image& picture, const ViewSettings& settings) {
  writeImage(path,
             path.extension() == ".exr" ? picture : toDisplay(picture, settings.exposure, settings.toneMap));
}

Recording::Recording(const std::filesystem::path& captures, const char* stem,
                     std::vector<CameraOptions> cameras, bool exr)
    : folder_(freeName(captures, stem, "")), cameras_(std::move(cameras)), exr_(exr) {
  makeFolder(folder_);
}

void Recording::write(const Image& picture, const ViewSettings& settings) {
  writePicture(folder_ / fmt::format("frame-{:04}{}", next_ + 1, exr_ ? ".exr" : ".png"), picture, settings);
  ++next_;
}

}  // namespace boxlight::gpu
