// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/scene/chart_mesh.h"
#include "common/base/progress.h"

namespace boxlight {

/// No normal of a chart is farther from its axis: lengths shrink at most to this when it is projected, so
/// that texel density stays within 2x. (The hundredth is for splits, whose axes are found anew.)
inline constexpr double kConeCosine = 0.51;
inline constexpr uint64_t kGrowPasses =
    4;  ///< growCharts advances its progress by so many times the triangles

/// Cuts the mesh into connected charts of triangles, each inside a cone of normals. Deterministic; time
/// O(n log n).
std::vector<std::vector<uint32_t>> growCharts(const ChartMesh& mesh, Progress& progress);

/// The direction along which `triangles` are projected: their mean normal, or if that leaves some of them
/// beyond 40 degrees, the axis of a narrow cone around their normals.
dvec3 chartAxis(const ChartMesh& mesh, std::span<const uint32_t> triangles);

}  // namespace boxlight
