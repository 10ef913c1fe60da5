// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/image.h"
#include "runtime/vulkan/commands.h"

namespace boxlight::gpu {

/// The environment as the shading pass integrates it: a summed-area table of (W+1) x (H+1) entries, built on
/// the device from a light map by two passes of exact integer sums. Entry (x, y) holds the sums of R, G, B
/// over the texels left of and above lattice point (x, y), 42 bits each (shaders/sat_columns.comp), in units
/// of unit(). The result is the same on every device.
class LightTable {
 public:
  /// `lightMap`: RGB, from makeLightMap. Reads lightSize from the frame constants.
  LightTable(Device& device, Bindings& bindings, const Image& lightMap);

  void build(Commands& commands) const;
  uvec2 size() const { return size_; }
  float unit() const { return unit_; }  ///< radiance times steradian
  const Buffer& entries() const { return entries_; }

 private:
  uvec2 size_;
  float unit_;
  Buffer lightMap_, rowFactors_, rowSums_, entries_;
  ComputePipeline rows_, columns_;
};

}  // namespace boxlight::gpu
