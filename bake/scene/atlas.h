// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bake/scene/charting.h"
#include "bake/scene/scene.h"
#include "bake/scene/texel_density.h"

namespace boxlight {

/// Where the atlas comes from. `automatic`: TEXCOORD_0, else TEXCOORD_1, if unique, inside [0,1], of even
/// density and with gutters; else charts.
enum class AtlasSource { automatic, chart, texcoord0, texcoord1 };

struct AtlasOptions {
  uint32_t size = 256;  ///< texels per side
  AtlasSource source = AtlasSource::automatic;
  ProgressStyle progress = ProgressStyle::none;
};

/// What chooseAtlas did.
struct AtlasReport {
  uint32_t uvSet = asset::kNone;  ///< or kNone: charted
  std::string reason;  ///< why not the scene's own UV sets; empty if one was taken or none was wanted
  Charting charting;   ///< if charted
  TexelDensity density;

  std::string summary() const;  ///< one line for the user
};

/// The automatic source passes over a UV set that gives a hundredth of the surface less than the mean density
/// divided by this. docs/decisions/004-starved-uv-sets.md
inline constexpr double kMostStarved = 8;

/// And one of whose charts more than this bleeds into others at the atlas's size (measureBleeding).
/// docs/decisions/005-uv-sets-that-bleed.md
inline constexpr double kMostBleeding = 0.02;

/// Sets Vertex::atlasUv; charting adds vertices. Errors: ExitCode::unsupported if the source is a UV set that
/// cannot be the atlas; ExitCode::interrupted.
AtlasReport chooseAtlas(Scene& scene, const AtlasOptions& options);

}  // namespace boxlight
