// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "common/asset/asset.h"
#include "runtime/kernels/visibility.h"
#include "runtime/vulkan/pipeline.h"

namespace boxlight::gpu {

/// The visibility maps of the visible records whose lobes are split, and where they lie. As the camera moves,
/// missing ones are added and those that are there stay, as long as one storage buffer holds them.
class VisibilityMaps {
 public:
  /// Holds nothing yet. `asset` must outlive it.
  VisibilityMaps(Device& device, Bindings& bindings, const asset::Asset& asset);

  /// Error(ExitCode::runtime) if the maps of `visible` are more than a storage buffer of the device.
  void require(std::span<const VisibleRecord> visible);
  uint64_t bytes() const { return buffer_.size(); }

 private:
  std::vector<uint32_t> missing(std::span<const VisibleRecord> visible) const;
  uint64_t bytesWith(size_t maps) const;

  Device& device_;
  Bindings& bindings_;
  const asset::Asset& asset_;
  std::vector<uint32_t> source_;  // by record its place in asset.visibilityMaps, or kAbsent
  std::vector<uint32_t> words_;   // by record the word where its map starts in the buffer, or kAbsent
  size_t count_ = 0;              // maps in the buffer
  Buffer buffer_;                 // words_, then maps
};

}  // namespace boxlight::gpu
