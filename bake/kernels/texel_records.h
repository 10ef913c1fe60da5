// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/scene/texels.h"
#include "bake/transport/paths.h"
#include "common/asset/asset_format.h"

namespace boxlight {

/// One side of one texel that will be baked, and which kernels its material asks for.
struct RecordPlan {
  asset::TexelRecord record;
  uint32_t texel;  ///< index into TexelMap::texels
  bool lambert, glossy;

  PathOrigin origin(const TexelMap& map) const;
};

/// The records of a scene in texel order: the front of every covered texel and, where its material is
/// double-sided, the back.
std::vector<RecordPlan> planRecords(const Scene& scene, const TexelMap& map);

/// The records that each atlas texel shows; gutter texels show those of their nearest covered texel.
std::vector<asset::AtlasTexel> indirection(const TexelMap& map, const std::vector<RecordPlan>& records);

}  // namespace boxlight
