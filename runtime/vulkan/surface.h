// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vulkan/vulkan_core.h>

#include <functional>
#include <vector>

namespace boxlight::gpu {

/// What a device must know of the window it is to draw in; the window itself is somebody else's.
struct WindowSystem {
  std::vector<const char*> instanceExtensions;
  std::function<VkResult(VkInstance, VkSurfaceKHR*)>
      makeSurface;  ///< called once; the device owns the surface
};

}  // namespace boxlight::gpu
