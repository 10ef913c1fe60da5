// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "bake/kernels/box_fit.h"
#include "bake/kernels/texel_records.h"
#include "bake/kernels/visibility_fit.h"
#include "bake/transport/paths.h"
#include "common/light/view_sphere.h"
#include "common/light/visibility_map.h"

namespace boxlight {

/// What one kernel is made from and into.
struct KernelOptions {
  uint32_t paths = 256;  ///< per glossy kernel and lobe
  uint32_t boxes = 8;    ///< per glossy kernel of one lobe, 1 to 64
  PathLimits limits;
  uint64_t seed = 0;
  uint32_t cellFrequency = 6;  ///< of the sphere of direction cells

  /// The Lambert kernel is stored once where glossy ones are stored per view: it can afford more of both.
  uint32_t lambertPaths() const { return 64 * paths; }
  uint32_t lambertBoxes() const { return std::min(4 * boxes, kMaxFittedBoxes); }
  /// A kernel of several view-dependent lobes has peaks in several directions.
  uint32_t glossyPaths(uint32_t lobes) const { return std::min(lobes, 2u) * paths; }
  uint32_t glossyBoxes(uint32_t lobes) const {
    return std::min(std::min(lobes, 2u) * boxes, kMaxFittedBoxes);
  }
  /// For what surfaces send into a lobe whose direct light takes no boxes: three eighths at a view, half in a
  /// direction cell, whose sharpness is what it is stored for (docs/decisions/006-split-lobes.md).
  uint32_t hiddenBoxes(bool inCells) const { return inCells ? (boxes + 1) / 2 : (3 * boxes + 7) / 8; }
  /// Slots of a split kernel: its hidden part, the boxes for it, and those of whole lobes.
  uint32_t splitSlots(const RecordPlan& plan) const {
    const uint32_t whole = std::min(plan.unmirrored, 2u) * boxes;
    return 1 + std::min(hiddenBoxes(plan.hasCells()) + whole, kMaxFittedBoxes - 1);
  }
  uint32_t glossySlots(const RecordPlan& plan) const {
    return plan.isSplit() ? splitSlots(plan) : glossyBoxes(plan.glossyLobes);
  }

  static constexpr uint32_t kMaxFittedBoxes = 64;
  /// Of a view's lobe: a hidden part below it has no kernel, unless an emitter is seen there. The pixel shows
  /// what the views around say of their hidden parts, or else the rest of the lobe (docs/theory.md, section
  /// 5).
  static constexpr float kLeastHiddenPart = 1.0f / 64;
  /// Coarse views lie too far apart to speak for one that says nothing: they keep any hidden part.
  static float leastHiddenPart(bool coarse) { return coarse ? 1e-6f : kLeastHiddenPart; }
};

/// How a Lambert kernel is fitted: at most three quarters of its boxes stand for the light that arrives
/// straight, the others for what comes from other surfaces and out of media.
inline VisibilityFitter::Options straightFit(uint32_t boxes) {
  return {.boxes = int(std::max(3 * boxes / 4, 1u))};
}

struct RecordKernel {
  /// As many slots as was asked for, emitted radiance not among them; empty if the record has no such kernel.
  std::vector<PackedBox> slots;
  Rgb emission{0.0f};  ///< radiance from the scene's emitters
};

/// The kernels of one record as they will stand in the pages.
struct RecordKernels {
  RecordKernel lambert;
  std::vector<RecordKernel> glossy;         ///< [view] of the record's sphere, or empty
  std::vector<RecordKernel> cells;          ///< [direction cell], or empty
  std::optional<VisibilityMap> visibility;  ///< of a split record
  double energy = 0, removed = 0;  ///< luminance of all deposits, and what PathLimits::throughput took
};

/// The bake's sphere of views, then those of kViewsByRoughness: by RecordPlan::viewSphere.
std::vector<ViewSphere> viewSpheres(const ViewSphere& sphere);

/// Bakes records one by one; owns scratch memory, so keep one per thread. What it returns depends on its
/// arguments alone.
class TexelBaker {
 public:
  TexelBaker(const Intersector& world, const TexelMap& map, const ViewSphere& sphere,
             const KernelOptions& options);

  /// A glossy kernel gets `glossySlots`, at least those of KernelOptions::glossySlots: all records of a tile
  /// agree in it.
  RecordKernels bake(const RecordPlan& plan, uint32_t glossySlots);

  /// The paths that the record's kernel of a view (of a direction cell, if it has those), or without one its
  /// Lambert kernel, is fitted to. Valid until the next call.
  const KernelPaths& retrace(const RecordPlan& plan, std::optional<uint32_t> view);

 private:
  PathOrigin start(const RecordPlan& plan);
  void traceLambert(const PathOrigin& origin, RecordKernels& result);
  void bakeLambert(const PathOrigin& origin, RecordKernels& result);
  struct GlossyKernels {
    const ViewSphere& sphere;
    uint32_t firstStream, paths, slots;  // of each
  };
  void bakeWhole(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result);
  void bakeSplit(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result);
  void bakeCells(const RecordPlan& plan, const PathOrigin& origin, const GlossyKernels& kernels,
                 RecordKernels& result);
  void traceCell(const RecordPlan& plan, const PathOrigin& origin, uint32_t cell,
                 const GlossyKernels& kernels, RecordKernels& result);
  RecordKernel hiddenKernel(uint32_t slots);
  void traceView(const PathOrigin& origin, uint32_t view, const GlossyKernels& kernels,
                 RecordKernels& result);
  void account(RecordKernels& result) const;
  std::vector<Box> fit(uint32_t boxes);

  const Intersector& world_;
  const TexelMap& map_;
  std::vector<ViewSphere> spheres_;  // by RecordPlan::viewSphere
  ViewSphere cells_;
  KernelOptions options_;
  PathTracer tracer_;
  VisibilityFitter straightFitter_;
  BoxFitter fitter_;
  KernelPaths paths_;
  StreamKey key_;
};

}  // namespace boxlight
