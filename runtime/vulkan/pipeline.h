// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "runtime/vulkan/buffer.h"

namespace boxlight::gpu {

class RasterTarget;

/// The one set of resources that every shader sees, numbered in shaders/shared.h: storage buffers, the
/// visibility image and, of some buffers, the same as texel buffers.
class Bindings {
 public:
  explicit Bindings(const Device& device);
  ~Bindings();

  /// Not while commands that use the set are recorded or run. Where the device has large texel buffers, those
  /// bindings that shaders/shared.h lists twice are set as both.
  void set(uint32_t binding, const Buffer& buffer);
  void setVisibilityImage(const RasterTarget& target);

  struct Native;
  const Native& native() const { return *native_; }

 private:
  void setTexels(size_t twin, const Buffer& buffer);

  const Device& device_;
  std::unique_ptr<Native> native_;
  Buffer empty_;  // stands where nothing was set
};

/// `constants` are the specialisation constants 0, 1, ... of the shader. What was compiled stays with the
/// device: the same again costs nothing.
class ComputePipeline {
 public:
  ComputePipeline(const Device& device, const Bindings& bindings, std::span<const uint32_t> code,
                  std::span<const uint32_t> constants = {});
  ~ComputePipeline();
  ComputePipeline(ComputePipeline&&) noexcept;
  ComputePipeline& operator=(ComputePipeline&&) noexcept;

  const Bindings& bindings() const { return *bindings_; }
  struct Native;
  const Native& native() const { return *native_; }

 private:
  const Bindings* bindings_;
  std::unique_ptr<Native> native_;
};

}  // namespace boxlight::gpu
