// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/present_loop.h"

namespace boxlight::gpu {

bool PresentLoop::acquire(uvec2 framebufferSize) {
  if (stale_ || size_ != framebufferSize) {
    target_.recreate(framebufferSize);
    size_ = framebufferSize;
    stale_ = false;
  }
  if (target_.extent().x == 0 || target_.extent().y == 0) {
    stale_ = true;
    return false;
  }
  const SurfaceState state = target_.acquire();
  stale_ = state != SurfaceState::ready;
  return state != SurfaceState::outOfDate;
}

bool PresentLoop::show(uvec2 framebufferSize, const std::function<void()>& draw) {
  if (framebufferSize.x == 0 || framebufferSize.y == 0) return false;
  constexpr int kTries = 2;
  for (int i = 0; i < kTries; ++i) {
    if (!acquire(framebufferSize)) continue;
    draw();
    const SurfaceState state = target_.present();
    stale_ = stale_ || state != SurfaceState::ready;
    return state != SurfaceState::outOfDate;
  }
  return false;
}

}  // namespace boxlight::gpu
