// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "common/asset/asset_reader.h"
#include "runtime/kernels/visibility.h"
#include "runtime/vulkan/pipeline.h"

namespace boxlight::gpu {

/// The pages of an asset that a camera needs, in one to kMaxBoxPools storage buffers, and the table that
/// finds them.
class ResidentPages {
 public:
  /// Needs for each visible record the Lambert kernel and, if it is seen, the glossy kernels of the three
  /// views nearest to the eye; reads and decodes those pages with `threads` threads (0 = all). A pool is no
  /// larger than `poolBytes`, nor than the device allows. Errors: those of AssetReader::page;
  /// ExitCode::runtime if kMaxBoxPools pools do not hold the pages.
  ResidentPages(Device& device, Bindings& bindings, const asset::AssetReader& reader,
                std::span<const VisibleRecord> visible, vec3 eye, uint64_t poolBytes, int threads);

  uint32_t poolCount() const { return uint32_t(pools_.size()); }  ///< at least 1
  uint32_t pageCount() const { return pageCount_; }
  uint64_t bytes() const;  ///< of decoded boxes
  bool emitters() const;   ///< has any kernel a slot of emitted radiance?
  /// Integrals over boxes that a frame takes for these records, no more than `boxLimit` for each kernel.
  uint64_t countBoxes(const asset::Asset& asset, std::span<const VisibleRecord> visible,
                      uint32_t boxLimit) const;

 private:
  std::vector<uint8_t> lambertEmits_, glossyEmits_;  // by tile: 1 if slot 0 is not a box
  uint32_t pageCount_ = 0;
  std::vector<Buffer> pools_;
  Buffer table_;
};

}  // namespace boxlight::gpu
