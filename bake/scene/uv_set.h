// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bake/scene/scene.h"

namespace boxlight {

/// What rasterising one UV set found. A set can be the atlas if it lies inside [0,1], no sample of the unit
/// square is covered twice (beyond a few that rounding explains), and no visible part of the surface has lost
/// its area.
struct UvSetReport {
  bool missing = false;  ///< on some primitive; then nothing below is known
  bool inside = true;
  double overlap = 0;  ///< covered samples that are covered more than once, as a fraction of the covered ones
  double collapsed = 0;  ///< surface area whose triangles have no UV area, as a fraction of the whole surface
  uint64_t samples = 0;  ///< covered, of 2048 x 2048
  std::string fault() const;  ///< why the set cannot be the atlas, as a predicate; empty if it can
};

UvSetReport inspectUvSet(const Scene& scene, uint32_t set);

}  // namespace boxlight
