// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/scene/chart_mesh.h"

namespace boxlight {

/// The cone inside which charts grow and merge. NormalSet rounds directions by up to 7.6 degrees: what it
/// holds inside 52 degrees is inside the 60 of kConeCosine.
inline constexpr double kGrowCosine = 0.6156614753256583;

/// Joins neighbouring charts whose normals fit one cone, first those that share most of a border.
/// `chart` numbers the chart of every triangle, in [0, count); returns the new count, numbers without gaps.
uint32_t mergeCharts(const ChartMesh& mesh, std::vector<uint32_t>& chart, uint32_t count);

}  // namespace boxlight
