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
  uint32_t paths = 256;  ///< per glossy kernel
  uint32_t boxes = 8;    ///< per glossy kernel, 1 to 64
  uint32_t bounces = kUnlimitedBounces;
  uint64_t seed = 0;

  /// The Lambert kernel is stored once where glossy ones are stored per view: it can afford more of both.
  uint32_t lambertPaths() const { return 64 * paths; }
  uint32_t lambertBoxes() const { return std::min(4 * boxes, 64u); }
};

/// The kernels of one record as they will stand in the pages: an empty list where the record has none.
struct RecordKernels {
  std::vector<PackedBox> lambert;
  std::vector<std::vector<PackedBox>> glossy;  ///< [view], each of KernelOptions::boxes slots, or empty
};

/// Bakes records one by one; owns scratch memory, so keep one per thread. What it returns depends on its
/// arguments alone.
class TexelBaker {
 public:
  TexelBaker(const Intersector& world, const TexelMap& map, const ViewSphere& sphere,
             const KernelOptions& options);

  RecordKernels bake(const RecordPlan& plan);

 private:
  std::vector<Box> lambertBoxes(const PathOrigin& origin, uint32_t stream);
  std::vector<Box> glossyBoxes(const PathOrigin& origin, uint32_t stream, vec3 wo);

  const TexelMap& map_;
  const ViewSphere& sphere_;
  KernelOptions options_;
  PathTracer tracer_;
  BoxFitter lambertFitter_, glossyFitter_;
  std::vector<Deposit> deposits_;
  StreamKey key_;
};

}  // namespace boxlight
