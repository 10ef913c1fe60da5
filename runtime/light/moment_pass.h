// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "runtime/vulkan/commands.h"

namespace boxlight::gpu {

/// The moments of the light, int L w dw, as the shading passes read them for cosine boxes and wide lobes:
/// prefix sums on the lattice of kMomentSize, the hemispheres above a grid of normals, the bright texels and
/// the light's trees (shaders/shared.h: kMomentColumns), made on the device from the light map. The sums are
/// of integers, the same on every device; a row is off by one unit at most. There are two tables: one is read
/// while the other is built.
class MomentPass {
 public:
  /// `bindings`: of the light's passes; the light map, of `mapSize`, is bound there.
  /// Without `trees` the table ends before them.
  MomentPass(Device& device, Bindings& bindings, uvec2 mapSize, bool trees);

  /// Of the light to build: radiance times steradian of its strongest channel over the whole sphere, and how
  /// many times that its map may have.
  void setTotal(Device& device, Bindings& bindings, double total, double margin);
  void build(Commands& commands) const;
  /// After the build has run: shows what was built.
  void flip();
  const Buffer& shown() const { return tables_[shown_]; }
  float unit() const { return unit_; }  ///< of the table that is shown: radiance times steradian

 private:
  uvec2 mapSize_;
  uint32_t rowShares_ = 0, shown_ = 0;
  float unit_ = 1, nextUnit_ = 1;
  Buffer constants_, covers_, weights_, texels_, cells_;
  std::vector<Buffer> tables_;
  ComputePipeline moments_, rows_, columns_, brightTexels_, cellSums_, nodes_;
  std::optional<ComputePipeline> trees_;
};

}  // namespace boxlight::gpu
