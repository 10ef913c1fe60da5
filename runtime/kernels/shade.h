// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset.h"
#include "common/light/relight.h"
#include "runtime/kernels/surface_constants.h"
#include "runtime/vulkan/commands.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// Demodulated radiance of texel records, diffuse and glossy, and with normal maps the gradients of diffuse:
/// see kShadedRadiances of shaders/shared.h.
class ShadedRecords {
 public:
  ShadedRecords(Device& device, Bindings& bindings, const asset::Asset& asset);
  std::vector<vec4> read(Device& device) const;

 private:
  Buffer buffer_;
};

/// Equation 3 for every record on the list. Made when the resident pages are known: how many pools they fill
/// and whether anything in them emits is compiled in. `exactSums`: of the light's table.
class ShadePass {
 public:
  ShadePass(Device& device, const Bindings& bindings, const asset::Asset& asset, uint32_t poolCount,
            bool emitters, Interpolation interpolation, bool exactSums);
  /// `list`: VisibleHeader and records.
  void shade(Commands& commands, const Buffer& list) const;

 private:
  ComputePipeline pipeline_;
};

/// Filters shaded records, multiplies the material in and lays blended layers over each other: RGBA of one
/// image tile.
class ResolvePass {
 public:
  /// `tilePixels`: pixels of the largest image tile.
  ResolvePass(Device& device, Bindings& bindings, const SurfaceConstants& constants, uint64_t tilePixels);
  /// `layers`: blended ones that were drawn of the tile.
  void resolve(Commands& commands, const ImageTile& tile, uint32_t layers) const;
  std::vector<vec4> read(Device& device, const ImageTile& tile) const;  ///< rows of the tile

 private:
  Buffer picture_;
  ComputePipeline pipeline_;
};

}  // namespace boxlight::gpu
