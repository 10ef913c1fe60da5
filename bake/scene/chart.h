// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bake/scene/chart_mesh.h"

namespace boxlight {

/// A connected piece of surface, laid flat.
struct Chart {
  std::vector<uint32_t> triangles;  ///< of the mesh
  std::vector<uvec3> corners;       ///< of each, into points; counter-clockwise
  std::vector<dvec2> points;        ///< metres times the texel scale, in [0, size]
  dvec2 size{0.0};                  ///< of the tightest upright rectangle found, width >= height
};

/// Projects triangles along their chartAxis and turns the picture until its rectangle is tight.
Chart flatten(const ChartMesh& mesh, std::vector<uint32_t> triangles);

/// Atlas coordinates are whole multiples of 2^-24, which floats in [0,1] hold exactly: what is decided about
/// them in integers is true of the stored atlas.
inline constexpr double kAtlasUnits = 16777216;
inline constexpr int kLeastExtent =
    8;  ///< units, to which a triangle that is too thin to have area is widened

/// The chart's points in units at `unitsPerMetre`, from 0. A lone triangle without area there gets a small
/// one.
std::vector<ivec2> snap(const Chart& chart, double unitsPerMetre);

/// Triangles of the chart (numbers in its list) that have no area in these points or show their back.
std::vector<uint32_t> findFlipped(const Chart& chart, const std::vector<ivec2>& points);

/// Two triangles of the chart whose insides overlap; none may be flipped. Exact, but for layouts so crowded
/// that a proof would take more than O(n log n): those are said to overlap.
std::optional<std::pair<uint32_t, uint32_t>> findOverlap(const Chart& chart,
                                                         const std::vector<ivec2>& points);

/// The triangles of a chart in two lists: those nearer to its triangle `a`, in steps over edges, and the
/// rest.
std::pair<std::vector<uint32_t>, std::vector<uint32_t>> splitBetween(const ChartMesh& mesh,
                                                                     const Chart& chart, uint32_t a,
                                                                     uint32_t b);

/// The triangles of a chart in two lists of equal length: those first reached from one end of it, and the
/// rest.
std::pair<std::vector<uint32_t>, std::vector<uint32_t>> halve(const ChartMesh& mesh, const Chart& chart);

}  // namespace boxlight
