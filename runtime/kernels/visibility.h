// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "runtime/vulkan/commands.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// What the camera sees: the triangle at each visibility sample of an image tile, and the texel records
/// behind all of them.
class VisibilityPass {
 public:
  /// `tileSamples`: samples of the largest image tile, each way.
  VisibilityPass(Device& device, Bindings& bindings, const asset::Asset& asset, uvec2 tileSamples);

  void clear(Commands& commands) const;  ///< forgets all records
  void draw(Commands& commands, const ImageTile& tile, uint32_t samples) const;
  void mark(Commands& commands, const ImageTile& tile) const;  ///< the records of the tile just drawn
  void compact(Commands& commands) const;                      ///< marks of all tiles to the list

  /// VisibleHeader, then the indices of the records.
  const Buffer& list() const { return list_; }
  std::vector<uint32_t> readList(Device& device) const;  ///< ascending

 private:
  uint32_t recordCount_, vertexCount_;
  Buffer marks_, list_;
  RasterTarget target_;
  RasterPipeline raster_;
  ComputePipeline mark_, compact_;
};

/// Work groups of kPixelGroup threads each way over `size` threads.
uvec3 imageGroups(uvec2 size);

}  // namespace boxlight::gpu
