// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/image.h"
#include "runtime/vulkan/commands.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// What a window shows: the last complete picture, of any size, beside the truth, after exposure and tone
/// map. A picture is put together tile by tile behind the one that is shown.
class Display {
 public:
  explicit Display(Device& device);

  void beginPicture(uvec2 size);
  /// `pixels`: those of the tile, vec4 row by row (FrameRenderer::pixels).
  void addTile(const Buffer& pixels, const ImageTile& tile);
  void endPicture();  ///< and shows it
  /// RGBA, or RGB as opaque.
  void setTruth(const Image& truth);

  /// Fills the display of `size` pixels, if it would change; columns from `split` on show the truth.
  void compose(uvec2 size, ToneMap toneMap, float exposure, uint32_t split);
  const DisplayPush& push() const { return push_; }  ///< of the last compose()
  const Bindings& bindings() const { return bindings_; }
  std::vector<uint32_t> read();  ///< the display: RGBA8, R in the low byte

 private:
  struct Picture {
    uvec2 size;
    Buffer pixels;
  };
  void fit(Picture& picture, const char* name, uvec2 size);

  Device& device_;
  Bindings bindings_;
  ComputePipeline pipeline_;
  Picture shown_, next_, truth_;
  Buffer display_;
  DisplayPush push_{};
  bool stale_ = true;  // is there another picture or truth than was composed?
};

}  // namespace boxlight::gpu
