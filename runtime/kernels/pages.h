// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "common/asset/asset_reader.h"
#include "runtime/kernels/visibility.h"
#include "runtime/vulkan/pipeline.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// The pages of an asset that a camera needs, in one to kMaxBoxPools storage buffers, and the table that
/// finds them. As the camera moves, missing pages are added and those that are there stay, up to a limit.
class ResidentPages {
 public:
  /// Holds nothing yet. A pool is no larger than `poolBytes`, nor than the device allows; pages are read and
  /// decoded with `threads` threads (0 = all). `reader` must outlive it.
  ResidentPages(Device& device, Bindings& bindings, const asset::AssetReader& reader, uint64_t poolBytes,
                int threads);

  /// Loads what is missing of each visible record: the Lambert kernel and, if it is seen, the glossy kernels
  /// of the three views nearest to the eye, or if it has direction cells all of those. Pages that are not
  /// needed are forgotten once they would take more than kKeptBytes or more than the pools. Returns once all
  /// are there. Errors: those of AssetReader::page; ExitCode::runtime if kMaxBoxPools pools do not hold what
  /// is needed.
  void require(std::span<const VisibleRecord> visible, vec3 eye);

  static constexpr uint64_t kKeptBytes = uint64_t(1) << 30;
  uint32_t poolCount() const { return uint32_t(pools_.size()); }  ///< at least 1 after require()
  uint32_t pageCount() const { return pageCount_; }
  uint64_t bytes() const;  ///< of the pools
  bool emitters() const;   ///< has any kernel a slot of emitted radiance?
  /// Integrals over boxes that a frame takes for these records, no more than `boxLimit` for each kernel;
  /// those of direction cells, which are for pixels, not counted.
  uint64_t countBoxes(std::span<const VisibleRecord> visible, uint32_t boxLimit) const;

 private:
  struct Page {
    uint32_t stream, tile;
  };
  struct Pool {
    Buffer buffer;
    uint64_t boxes = 0;  // in use
  };

  std::vector<Page> neededPages(std::span<const VisibleRecord> visible, vec3 eye) const;
  PageSlot& slot(Page page);
  uint64_t boxesOf(Page page) const;
  void forget();
  void load(const std::vector<Page>& pages);
  std::vector<uint64_t> place(const std::vector<Page>& pages);
  void requireFit(const std::vector<uint64_t>& used) const;
  void noteEmission(Page page, const PackedBox& first);

  Device& device_;
  Bindings& bindings_;
  const asset::AssetReader& reader_;
  uint64_t poolCapacity_;  // boxes
  int threads_;
  std::vector<uint8_t> lambertEmits_, glossyEmits_;  // by tile: 1 if slot 0 is not a box
  uint32_t pageCount_ = 0;
  std::vector<Pool> pools_;
  std::vector<PageSlot> slots_;  // what table_ holds
  Buffer table_;
};

}  // namespace boxlight::gpu
