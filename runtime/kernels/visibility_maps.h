// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "common/asset/asset.h"
#include "runtime/kernels/visibility.h"
#include "runtime/vulkan/pipeline.h"

namespace boxlight::gpu {

/// The visibility maps of the visible records whose lobes are split, and where they lie.
class VisibilityMaps {
 public:
  /// Error(ExitCode::runtime) if they are more than a storage buffer of the device.
  VisibilityMaps(Device& device, Bindings& bindings, const asset::Asset& asset,
                 std::span<const VisibleRecord> visible);
  uint64_t bytes() const { return buffer_.size(); }

 private:
  Buffer buffer_;
};

}  // namespace boxlight::gpu
