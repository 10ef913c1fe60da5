// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/scene.h"
#include "common/base/progress.h"

namespace boxlight {

/// What charting made of a scene.
struct Charting {
  uint32_t charts = 0;
  uint32_t shared = 0;        ///< charts that share a rectangle of the atlas with others
  double crumb = 0;           ///< texels: charts up to this long, or an eighth as high, may share
  uint32_t gutter = 0;        ///< texels between rectangles: 2, 4 or 8 (chart_pack.h)
  double texelsPerMetre = 0;  ///< where the texel scale is 1, before projection shortens it
};

/// Cuts the scene into charts, lays them flat and packs them: sets every vertex' atlasUv and gives the
/// vertices at borders a copy per chart. atlasSize: texels per side. Every triangle gets area in the atlas,
/// no two overlap. One thread; throws Error(interrupted) after Ctrl-C.
Charting chartScene(Scene& scene, uint32_t atlasSize, ProgressStyle progress);

}  // namespace boxlight
