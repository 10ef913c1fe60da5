// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/light/environment_tilt.h"
#include "runtime/vulkan/commands.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// Makes the light map of an environment on the device, level (light_map.h: makeLightMap) or tilted
/// (environment_tilt.h: makeTiltedMap), with the same bits as on the CPU.
class LightMapPass {
 public:
  LightMapPass(Device& device, Bindings& bindings, uvec2 size);

  /// Uploads the environment, which fits into a storage buffer.
  void setImage(Device& device, Bindings& bindings, const Image& image);
  /// Uploads what the tilt asks for; after setImage. `image` is the same.
  void setTilt(Device& device, Bindings& bindings, const Image& image, EnvironmentTilt tilt);

  void make(Commands& commands) const;
  const Buffer& image() const { return image_; }
  const Buffer& map() const { return map_; }

 private:
  std::vector<float> levelTables(Device& device, Bindings& bindings, LightConstants& constants);

  uvec2 size_, imageSize_{0};
  bool level_ = true;
  uint32_t highlightCount_ = 0;
  Buffer constants_, image_, tables_, covers_, map_, highlights_;
  ComputePipeline levelMap_, tiltedMap_, addHighlights_;
};

}  // namespace boxlight::gpu
