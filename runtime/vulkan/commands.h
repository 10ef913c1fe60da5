// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "runtime/vulkan/raster.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// What Device::run records. Every command waits for the ones before it: the passes of a frame depend on each
/// other in order.
class Commands {
 public:
  struct Native;
  explicit Commands(Native& native) : native_(native) {}

  /// Records `commands` between two timestamps; Device::run returns the time between them under `name`.
  void pass(const char* name, const std::function<void()>& commands);

  void fill(const Buffer& buffer, uint32_t value);
  /// `push` is the push-constant block, if the shader has one.
  void dispatch(const ComputePipeline& pipeline, uvec3 groups, std::span<const std::byte> push = {});
  /// Group counts are three words at `offset` of `counts`.
  void dispatchIndirect(const ComputePipeline& pipeline, const Buffer& counts, uint64_t offset);
  /// The upper left `extent` of a target, row by row: its pairs, or its depths as floats (RasterFormat).
  void copySamples(const RasterTarget& target, uvec2 extent, const Buffer& to, uint64_t offset);
  void copyDepth(const RasterTarget& target, uvec2 extent, const Buffer& to, uint64_t offset);
  /// A tile's pixels, vec4 row by row, into a picture that is `width` pixels wide.
  void copyTile(const Buffer& from, const Buffer& to, const ImageTile& tile, uint32_t width);
  /// Clears the target, then draws into its upper left `extent`.
  void draw(const RasterPipeline& pipeline, const RasterTarget& target, uvec2 extent, uint32_t vertexCount,
            std::span<const std::byte> push);

 private:
  void barrier();
  void bind(const Bindings& bindings, bool graphics, std::span<const std::byte> push);

  Native& native_;
};

}  // namespace boxlight::gpu
