// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "runtime/kernels/surface_constants.h"
#include "runtime/vulkan/commands.h"

namespace boxlight::gpu {

/// Blended triangles between the eye and the opaque triangle of every sample of an image tile, front to
/// back: depth peeling, one draw of the blended triangles a layer. Of triangles at the same depth the later
/// one lies in front, and a blended one lies before an opaque one.
class LayerPass {
 public:
  /// `tileSamples`: samples of the largest image tile, each way; `limit`: layers of a sample at most.
  LayerPass(Device& device, Bindings& bindings, const asset::Asset& asset, const SurfaceConstants& constants,
            uvec2 tileSamples, uint32_t limit);

  /// For image tiles of another size.
  void resize(Device& device, Bindings& bindings, uvec2 tileSamples);

  struct Need {
    uint32_t layers = 0;      ///< that the image tile shows, no more than the limit
    uint64_t cutSamples = 0;  ///< samples that have more of them than the limit
  };
  /// Peels until a layer is empty and asks the device after each. `opaque`: the samples and depths of the
  /// tile's opaque triangles.
  Need find(Device& device, const RasterTarget& opaque, const ImageTile& tile, uint32_t samples) const;
  void draw(Commands& commands, const RasterTarget& opaque, const ImageTile& tile, uint32_t samples,
            uint32_t layers) const;

  /// Device memory for each sample of an image tile.
  static uint64_t bytesPerSample(uint32_t limit);

 private:
  void begin(Commands& commands, const RasterTarget& opaque, uvec2 extent) const;
  void peel(Commands& commands, const ImageTile& tile, uint32_t samples, uint32_t layer) const;
  uint64_t countLast(Device& device, const ImageTile& tile, uint32_t samples, uint32_t layers) const;

  uint32_t limit_;
  Buffer triangles_, layers_, depths_;
  RasterTarget target_;
  RasterPipeline raster_;
  ComputePipeline count_;
  uint32_t vertexCount_;
};

}  // namespace boxlight::gpu
