// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "bake/kernels/texel_bake.h"

namespace boxlight {

/// Which kernel of an atlas to look at.
struct KernelQuery {
  uvec2 texel{0};
  bool back = false;
  std::optional<uint32_t> view;  ///< or direction cell, if the texel has those; none: the Lambert kernel
};

/// One kernel beside what it was fitted to.
struct KernelStudy {
  KernelQuery query;
  uint32_t record = 0;  ///< index among the records
  RecordPlan plan;
  vec3 viewDirection{0.0f};  ///< as baked: a view's is raised above the horizon; 0 for a Lambert kernel
  /// Of a split record, without what its pixels reflect straight from the light.
  std::vector<Deposit> deposits;
  uint32_t traced = 0;                 ///< paths; a deposit is its throughput over this
  std::vector<Box> boxes;              ///< as they are stored, empty slots left out
  std::vector<CosineBox> cosineBoxes;  ///< of a Lambert kernel, which come before them
  Rgb emission{0.0f};
  std::optional<float> hiddenPart;  ///< of a split record's glossy kernel
  std::optional<VisibilityMap> visibility;
};

/// Bakes the texel again, with the numbers that a bake of the whole scene draws. Errors (ExitCode::usage): no
/// such texel, side, view or kernel; the message says what there is.
KernelStudy studyKernel(const Intersector& world, const TexelMap& map, const std::vector<RecordPlan>& records,
                        const ViewSphere& sphere, const KernelOptions& options, const KernelQuery& query);

/// What a kernel and its paths say of one light: demodulated radiance.
struct ProbeAnswer {
  const char* light;
  dvec3 paths{0.0}, boxes{0.0};
  double error() const;  ///< |boxes - paths| / |paths|; 0 if both are
};

/// Under a white sky, the six half skies around the axes, and six lamps of 10 degrees radius there; all of
/// mean radiance 1.
std::vector<ProbeAnswer> probeKernel(const KernelStudy& study);

}  // namespace boxlight
