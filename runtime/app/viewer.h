// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "runtime/app/session.h"
#include "runtime/app/stats.h"
#include "runtime/kernels/display.h"

namespace boxlight::gpu {

/// What limiting the boxes costs, in the picture at hand, over the object's pixels.
struct BoxError {
  double relative = 0;  ///< sqrt(sum (x - r)^2 / sum r^2), r with all boxes
  double rmse8 = 0;     ///< 8-bit sRGB steps
};

/// Draws a session a slice at a time, so that a window stays usable on devices that need a second a frame: a
/// changed camera gives a small picture within kQuickMs at once, and once it rests, the error of limited
/// boxes and the picture at full size, by bands of rows of about kSliceMs. What is shown is always complete.
class Viewer {
 public:
  static constexpr double kQuickMs = 60, kSliceMs = 40;

  Viewer(Device& device, int threads);
  ~Viewer();

  /// Loads and shows; on failure everything stays as it was. Errors: those of the readers and of the device.
  void openAsset(const std::filesystem::path& path, ViewSettings& settings);
  void openEnvironment(const std::filesystem::path& path);  ///< empty: radiance 1 everywhere
  const asset::Asset& asset() const;
  vec3 boundsMin() const;
  vec3 boundsMax() const;
  uint32_t mostBoxes() const;                     ///< of any kernel
  uvec2 lightSize() const { return lightSize_; }  ///< that asset and environment ask for

  /// Does the next slice of what the settings ask for. True if the display's picture is another one.
  bool work(const ViewSettings& settings);
  bool isResting() const { return stage_ == Stage::resting; }  ///< is there nothing left to do?
  /// The picture at full size and quality, as headless makes it.
  const Image& picture(const ViewSettings& settings);

  Display& display() { return display_; }
  const std::optional<BoxError>& boxError() const { return boxError_; }
  const FrameCounts& counts() const;
  const std::vector<PassTime>& times() const { return times_; }  ///< of the last picture
  double fraction() const;                                       ///< of the picture at full size that is done
  uvec2 shownSize() const { return shownSize_; }

 private:
  enum class Stage { resting, quick, measuring, starting, resolving };
  struct Scene;

  FrameSettings wantedFrame(const ViewSettings& settings) const;
  void apply(const FrameSettings& frame);
  uvec2 quickSize(uvec2 size) const;
  void drawQuick();
  void measureError();
  void startFull();
  void resolveBand();
  void finishPicture(uvec2 size);

  Device& device_;
  int threads_;
  Display display_;
  Image environment_;
  uvec2 lightSize_{0};
  bool environmentStale_ = false;
  std::unique_ptr<Scene> scene_;
  Stage stage_ = Stage::resting;
  FrameSettings wanted_;  // of the session
  uvec2 shownSize_{0};
  size_t tile_ = 0;
  uint32_t row_ = 0;
  std::vector<PassTime> times_, pending_;
  // Wall time of a pixel, from the last pictures.
  double quickMs_ = 0.01, bandMs_ = 0.004;
  std::optional<BoxError> boxError_;
  std::optional<FrameSettings> referenceOf_;  // what reference_ shows
  Image reference_;
};

}  // namespace boxlight::gpu
