// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/kernels/box_fit.h"
#include "bake/kernels/texel_records.h"
#include "bake/transport/paths.h"
#include "common/light/view_sphere.h"

namespace boxlight {

/// What one kernel is made from and into.
struct KernelOptions {
  uint32_t paths = 256;  ///< per glossy kernel and lobe
  uint32_t boxes = 8;    ///< per glossy kernel of one lobe, 1 to 64
  PathLimits limits;
  uint64_t seed = 0;

  /// The Lambert kernel is stored once where glossy ones are stored per view: it can afford more of both.
  uint32_t lambertPaths() const { return 64 * paths; }
  uint32_t lambertBoxes() const { return std::min(4 * boxes, kMaxFittedBoxes); }
  /// A kernel of several view-dependent lobes has peaks in several directions.
  uint32_t glossyPaths(uint32_t lobes) const { return std::min(lobes, 2u) * paths; }
  uint32_t glossyBoxes(uint32_t lobes) const {
    return std::min(std::min(lobes, 2u) * boxes, kMaxFittedBoxes);
  }

  static constexpr uint32_t kMaxFittedBoxes = 64;
};

struct RecordKernel {
  std::vector<PackedBox>
      boxes;           ///< of as many slots as was asked for; empty if the record has no such kernel
  Rgb emission{0.0f};  ///< radiance from the scene's emitters
};

/// The kernels of one record as they will stand in the pages.
struct RecordKernels {
  RecordKernel lambert;
  std::vector<RecordKernel> glossy;  ///< [view], or empty
  double energy = 0, removed = 0;    ///< luminance of all deposits, and what PathLimits::throughput took
};

/// Bakes records one by one; owns scratch memory, so keep one per thread. What it returns depends on its
/// arguments alone.
class TexelBaker {
 public:
  TexelBaker(const Intersector& world, const TexelMap& map, const ViewSphere& sphere,
             const KernelOptions& options);

  /// `glossyLobes` decides how many boxes a glossy kernel has; all records of a tile agree in it.
  RecordKernels bake(const RecordPlan& plan, uint32_t glossyLobes);

 private:
  void bakeLambert(const PathOrigin& origin, uint32_t stream, RecordKernels& result);
  void bakeGlossy(const PathOrigin& origin, uint32_t firstStream, uint32_t glossyLobes,
                  RecordKernels& result);
  std::vector<Box> fit(BoxFitter& fitter, uint32_t boxes, RecordKernels& result);

  const Intersector& world_;
  const TexelMap& map_;
  const ViewSphere& sphere_;
  KernelOptions options_;
  PathTracer tracer_;
  BoxFitter lambertFitter_, glossyFitter_;
  KernelPaths paths_;
  StreamKey key_;
};

}  // namespace boxlight
