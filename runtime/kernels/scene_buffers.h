// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "runtime/vulkan/pipeline.h"

namespace boxlight::gpu {

/// Everything of an asset but its boxes, on the device and bound. Error(ExitCode::runtime) naming the part
/// that is larger than a storage buffer of the device.
class SceneBuffers {
 public:
  SceneBuffers(Device& device, Bindings& bindings, const asset::Asset& asset);

  uint64_t bytes() const;

 private:
  std::vector<Buffer> buffers_;
};

}  // namespace boxlight::gpu
