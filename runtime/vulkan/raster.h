// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"
#include "runtime/vulkan/pipeline.h"

namespace boxlight::gpu {

/// What a target holds for each sample.
struct RasterFormat {
  bool pairs = false;        ///< two 32-bit words, to be copied to a buffer; else one, which compute reads
  bool copiedDepth = false;  ///< the depth can be copied to a buffer
};

/// One or two 32-bit words per sample, with a depth buffer behind them.
class RasterTarget {
 public:
  RasterTarget(Device& device, uvec2 size, RasterFormat format = {});
  ~RasterTarget();
  RasterTarget(RasterTarget&&) noexcept;
  RasterTarget& operator=(RasterTarget&&) noexcept;

  uvec2 size() const { return size_; }
  RasterFormat format() const { return format_; }
  struct Native;
  const Native& native() const { return *native_; }

 private:
  uvec2 size_;
  RasterFormat format_;
  std::unique_ptr<Native> native_;
};

/// Which of several triangles at the same depth a sample keeps.
enum class DepthTest { keepsFirst, keepsLast };

/// Triangles pulled from storage buffers by the vertex shader, for targets of one format. Nothing is culled
/// by winding; the depth test is reversed (greater is nearer) and cleared to 0 with the colour.
class RasterPipeline {
 public:
  RasterPipeline(const Device& device, const Bindings& bindings, const RasterTarget& target,
                 std::span<const uint32_t> vertexCode, std::span<const uint32_t> fragmentCode,
                 std::span<const uint32_t> constants, DepthTest depthTest = DepthTest::keepsFirst);
  ~RasterPipeline();
  RasterPipeline(RasterPipeline&&) noexcept;
  RasterPipeline& operator=(RasterPipeline&&) noexcept;

  const Bindings& bindings() const { return *bindings_; }
  struct Native;
  const Native& native() const { return *native_; }

 private:
  const Bindings* bindings_;
  std::unique_ptr<Native> native_;
};

}  // namespace boxlight::gpu
