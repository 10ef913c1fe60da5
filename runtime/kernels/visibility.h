// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "runtime/kernels/surface_constants.h"
#include "runtime/vulkan/commands.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

struct VisibleRecord {
  uint32_t record;
  bool glossy;  ///< false: only its Lambert radiance is asked for, by the other side of its texel
};

/// What the camera sees: the opaque triangle at each visibility sample of an image tile, and the texel
/// records behind all of them.
class VisibilityPass {
 public:
  /// `tileSamples`: samples of the largest image tile, each way.
  VisibilityPass(Device& device, Bindings& bindings, const asset::Asset& asset,
                 const SurfaceConstants& constants, uvec2 tileSamples);

  /// For image tiles of another size.
  void resize(Device& device, Bindings& bindings, uvec2 tileSamples);
  void clear(Commands& commands) const;  ///< forgets all records
  void draw(Commands& commands, const ImageTile& tile, uint32_t samples) const;
  /// The records of the tile just drawn and of its `layers` blended layers.
  void mark(Commands& commands, const ImageTile& tile, uint32_t layers) const;
  void compact(Commands& commands) const;  ///< marks of all tiles to the list

  const RasterTarget& target() const { return target_; }
  /// VisibleHeader, then the indices of the records, those without gloss with kLambertOnly.
  const Buffer& list() const { return list_; }
  std::vector<VisibleRecord> readList(Device& device) const;  ///< ascending

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
