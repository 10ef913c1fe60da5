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
  uint32_t texel;        ///< index into TexelMap::texels
  bool lambert = false;  ///< its own diffuse reflection, or the other side's diffuse transmission, needs it
  bool glossy = false;   ///< it is seen, and has view-dependent lobes
  uint32_t glossyLobes = 0;  ///< view-dependent lobes with directions of their own, at most
  uint32_t unmirrored = 0;   ///< those of them that no microfacets reflect

  /// Are the lobes that microfacets reflect split? (asset::Scheme::split)
  bool isSplit() const { return (record.flags & asset::kSplitLobe) != 0; }
  /// Are their hidden parts stored for the directions that light comes from? (asset::Scheme::cells)
  bool hasCells() const { return (record.flags & asset::kDirectionCells) != 0; }
  PathOrigin origin(const Intersector& world, const TexelMap& map) const;
};

/// The records of a scene in texel order: the front of every covered texel; the back where it is seen
/// (double-sided, and reached by light from outside) or where diffuse transmission gathers from it.
/// Scheme::split splits the lobes that microfacets reflect, but not inside a volume. Scheme::cells does so
/// too and stores in direction cells what one sharp round lobe (alpha at most kMaxCellAlpha) sees of other
/// surfaces.
inline constexpr float kMaxCellAlpha = 0.1f;
std::vector<RecordPlan> planRecords(const Intersector& world, const TexelMap& map,
                                    asset::Scheme scheme = asset::Scheme::sketch);

/// The records that each atlas texel shows; gutter texels show those of their nearest covered texel.
std::vector<asset::AtlasTexel> indirection(const TexelMap& map, const std::vector<RecordPlan>& records);

}  // namespace boxlight
