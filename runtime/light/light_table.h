// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/light/fixed_point.h"
#include "runtime/vulkan/commands.h"

namespace boxlight::gpu {

/// How the sums are shared out among threads; the sums are the same. automatic: one thread a row and a column
/// on a CPU, workgroups on any other device.
enum class SatBuild { automatic, threads, groups };

/// The environment as the shading pass integrates it: a summed-area table of (W+1) x (H+1) entries, built on
/// the device from a light map by two passes of exact integer sums. Entry (x, y) holds the sums of R, G, B
/// over the texels left of and above lattice point (x, y) (shaders/sat_columns.glsl), in units of the fixed
/// point that it is built with. The result is the same on every device. There are two tables: one is read
/// while the other is built.
class LightTable {
 public:
  /// `bindings`: of the light's passes; the light map is bound there. Error(ExitCode::runtime) if the device
  /// holds no buffers of that size.
  LightTable(Device& device, Bindings& bindings, uvec2 size, SatScheme scheme, SatBuild build);

  void setFixedPoint(Device& device, Bindings& bindings, const FixedPoint& fixedPoint);
  /// Sums the light map into the table that is not shown.
  void build(Commands& commands) const;
  /// After the build has run: shows what was built.
  void flip() { shown_ = 1 - shown_; }
  const Buffer& shown() const { return entries_[shown_]; }

 private:
  uvec2 size_;
  uint32_t shown_ = 0;
  Buffer rowFactors_, rowSums_;
  std::vector<Buffer> entries_;
  ComputePipeline rows_, columns_;
  uvec3 rowGroups_, columnGroups_;
};

}  // namespace boxlight::gpu
