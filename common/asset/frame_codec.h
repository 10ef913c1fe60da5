// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace boxlight::asset {

/// One zstd frame with its content size. One thread and a fixed level: the same input gives the same bytes
/// from the same version of libzstd. The result is valid until the next call of the same compressor.
class FrameCompressor {
 public:
  FrameCompressor();
  ~FrameCompressor();
  FrameCompressor(const FrameCompressor&) = delete;
  FrameCompressor& operator=(const FrameCompressor&) = delete;

  std::span<const std::byte> compress(std::span<const std::byte> raw);
  /// The same with blocks of these sizes, which add up to raw.size(): each may have codes of its own.
  std::span<const std::byte> compress(std::span<const std::byte> raw, std::span<const size_t> blocks);

 private:
  void* context_;
  std::vector<std::byte> buffer_;
};

/// Decodes `frame`, which must be exactly one zstd frame whose recorded content size is raw.size(); false if
/// it is not. Allocates nothing that grows with the frame. Safe to call from several threads.
bool decompressFrame(std::span<const std::byte> frame, std::span<std::byte> raw);

}  // namespace boxlight::asset
