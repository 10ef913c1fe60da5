// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "data/mesh.h"

namespace boxlight::data {

/// A bicubic Bezier patch: control points [row][column]; u runs along columns, v along rows.
using Patch = std::array<std::array<dvec3, 4>, 4>;

/// A sheet of patches that continue each other, [row][column]: one chart of the atlas.
struct PatchSheet {
  const char* name;
  std::vector<std::vector<Patch>> patches;
  std::vector<uint32_t> segments;  ///< quads along v in each row of patches
  uint32_t columnSegments;         ///< quads along u in each column
};

/// Martin Newell's teapot of 1975 in his own units and axes (+Z up, spout towards +X, 3.15 high): the 28
/// published patches, the 4 of the bottom that came later, and two of our own that close it: the ledge under
/// the lid and the mouth of the spout.
std::vector<PatchSheet> teapotSheets();

/// The sheet's surface in glTF's axes, scaled and then moved. Normals are the patches' own, also where one of
/// their sides shrinks to a point.
Chart tessellate(const PatchSheet& sheet, float scale, vec3 origin);

}  // namespace boxlight::data
