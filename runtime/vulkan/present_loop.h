// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "common/base/math.h"

namespace boxlight::gpu {

/// What a surface says of the images it was given.
enum class SurfaceState {
  ready,
  suboptimal,  ///< shown, but scaled or copied: the window has changed
  outOfDate,   ///< not shown
};

/// The images of a window, as PresentLoop sees them.
class PresentTarget {
 public:
  virtual ~PresentTarget() = default;
  virtual uvec2 extent() const = 0;                  ///< pixels of an image; 0 while there are none
  virtual void recreate(uvec2 framebufferSize) = 0;  ///< leaves no images where the window has no area
  virtual SurfaceState acquire() = 0;
  virtual SurfaceState present() = 0;
};

/// Shows frames in a window that may be resized, minimised or moved to another screen at any moment.
class PresentLoop {
 public:
  explicit PresentLoop(PresentTarget& target) : target_(target) {}

  /// Draws by `draw`, between acquiring and presenting an image of target.extent(). False if nothing was
  /// shown: the window has no area, or changed twice meanwhile; then try again after the next events.
  bool show(uvec2 framebufferSize, const std::function<void()>& draw);

 private:
  bool acquire(uvec2 framebufferSize);

  PresentTarget& target_;
  uvec2 size_{0};  // of the framebuffer that the images were made for
  bool stale_ = true;
};

}  // namespace boxlight::gpu
