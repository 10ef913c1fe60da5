// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "bake/scene/texels.h"
#include "bake/transport/paths.h"
#include "common/asset/asset_format.h"

namespace boxlight {

/// One side of one texel that will be baked, and which kernels its material asks for.
struct RecordPlan {
  asset::TexelRecord record;
  uint32_t texel;        ///< index into TexelMap::texels of its level
  bool lambert = false;  ///< its own diffuse reflection, or the other side's diffuse transmission, needs it
  bool glossy = false;   ///< it is seen, and has view-dependent lobes
  uint32_t glossyLobes = 0;  ///< view-dependent lobes with directions of their own, at most
  uint32_t unmirrored = 0;   ///< those of them that no microfacets reflect

  /// Are the lobes that microfacets reflect split? (asset::Scheme::split)
  bool isSplit() const { return (record.flags & asset::kSplitLobe) != 0; }
  /// Are their hidden parts stored for the directions that light comes from? (asset::Scheme::cells)
  bool hasCells() const { return (record.flags & asset::kDirectionCells) != 0; }
  /// Of its views: 0 is the bake's own sphere, others are kViewsByRoughness[number - 1].
  uint32_t viewSphere() const { return asset::viewSphereOf(record.flags); }
  PathOrigin origin(const Intersector& world, const TexelMap& map) const;
};

/// A texel's number for its streams of random numbers (StreamKey::texel): apart from those of other levels.
constexpr uint32_t streamTexel(uint32_t level, uint32_t texel) { return level << 28 | texel; }

/// Which views do for a record that stores no lobe, only what surfaces send into rough ones: those of the
/// last entry whose alpha its lobes reach (docs/decisions/013-views-by-roughness.md).
struct CoarseViews {
  uint32_t frequency;  ///< of their sphere
  float leastAlpha;
};
inline constexpr std::array<CoarseViews, 2> kViewsByRoughness = {{{2, 0.15f}, {1, 0.35f}}};

/// The records of a scene, level after level, in texel order: the front of every covered texel; the back
/// where it is seen (double-sided, and reached by light from outside) or where diffuse transmission gathers
/// from it. Scheme::split splits the lobes that microfacets reflect, but not inside a volume. Scheme::cells
/// does so too and stores in direction cells what one sharp round lobe (alpha at most kMaxCellAlpha) sees of
/// other surfaces. With `coarseViews`, split records whose lobes are all mirrored and rough have fewer views.
inline constexpr float kMaxCellAlpha = 0.1f;
std::vector<RecordPlan> planRecords(const Intersector& world, const TexelMap& map,
                                    asset::Scheme scheme = asset::Scheme::sketch, bool coarseViews = false);

/// The records that each texel of a level shows; gutter texels show those of their nearest covered texel.
std::vector<asset::AtlasTexel> indirection(const TexelMap& map, uint32_t level,
                                           const std::vector<RecordPlan>& records);

}  // namespace boxlight
