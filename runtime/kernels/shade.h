// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

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
/// and whether anything in them emits is compiled in.
class ShadePass {
 public:
  ShadePass(Device& device, const Bindings& bindings, const SurfaceConstants& constants);
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
  /// From the next prepare() on.
  void specialize(const SurfaceConstants& constants);
  /// For image tiles of another size.
  void resize(Device& device, Bindings& bindings, uint64_t tilePixels);
  /// Compiles what these settings need if it is not there. `layers`: blended ones of an image tile at most.
  void prepare(const Device& device, const Bindings& bindings, bool background, uint32_t layers);
  /// `layers`: blended ones that were drawn of the tile; `rows` of the tile from `firstRow` on. Takes the
  /// settings of the last prepare().
  void resolve(Commands& commands, const ImageTile& tile, uint32_t layers, uint32_t firstRow,
               uint32_t rows) const;
  const Buffer& pixels() const { return picture_; }  ///< of the tile last resolved, row by row
  std::vector<vec4> read(Device& device, const ImageTile& tile) const;  ///< rows of the tile

 private:
  struct Variant {
    bool background;
    uint32_t layers;
    ComputePipeline pipeline;
  };
  SurfaceConstants constants_;
  Buffer picture_;
  std::optional<Variant> variant_;
};

}  // namespace boxlight::gpu
