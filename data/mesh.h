// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "common/base/math.h"

namespace boxlight::data {

/// One chart of the atlas with its triangles. glTF's space and winding: counter-clockwise seen from the
/// front.
struct Chart {
  std::vector<vec3> positions, normals;  ///< metres; unit
  std::vector<vec2> texcoords;           ///< for textures; may repeat and overlap
  std::vector<vec2> atlas;  ///< [0,1]^2 of the chart, until packCharts turns it into [0,1]^2 of the atlas
  std::vector<uint32_t> indices;
  vec2 size{0.0f};  ///< metres along the chart's sides times its texel-density scale: what packCharts divides
                    ///< the atlas by
};

/// `columns` x `rows` quads over [0,1]^2, split along the shorter diagonal; `point(u, v, position, normal)`
/// fills one vertex. d position/du x d position/dv is the front. Triangles without area (at a pole) are left
/// out. `texcoords` = (u, v).
template <class Point>
Chart gridChart(uint32_t columns, uint32_t rows, vec2 size, Point point);

/// A rectangle: corner, corner + u, corner + u + v, corner + v, with normal u x v.
Chart rectangleChart(vec3 corner, vec3 u, vec3 v, uint32_t segments = 1);
/// A whole sphere (polarRange {0, pi}) or a band of it, measured from +Y; `inward` turns the front to the
/// centre. The chart is the longitude-latitude rectangle, as large as the surface it covers.
Chart sphereChart(vec3 centre, float radius, vec2 polarRange, uint32_t columns, uint32_t rows,
                  bool inward = false);
/// A flat disc around the Y axis facing +Y or -Y; the chart is the square around it.
Chart discChart(vec3 centre, float radius, uint32_t segments, uint32_t rings, bool up);
/// The wall of an upright cylinder, facing out.
Chart cylinderChart(vec3 base, float radius, float height, uint32_t segments);

/// Places the charts beside each other in the atlas: `atlas` of every chart becomes unique and lies inside
/// [0,1]. Chart borders are texel borders at `resolution`, at least `gutter` texels apart, and half of that
/// from the edge. All sizes share one scale, the largest that fits, so that texel density follows `size`.
/// Deterministic.
void packCharts(const std::vector<Chart*>& charts, uint32_t resolution = 128, uint32_t gutter = 2);

/// Adds the vertices and triangles of `part` behind those of `chart`; `size` stays.
void appendChart(Chart& chart, const Chart& part);

/// A closed surface's volume (positive if its triangles face out), and a surface's area: metres^3, metres^2.
double signedVolume(const Chart& chart);
double surfaceArea(const Chart& chart);

// ---- implementation of the template ----

/// Adds the two triangles of a quad given counter-clockwise, or the one that has area.
void addQuad(Chart& chart, uint32_t a, uint32_t b, uint32_t c, uint32_t d);

template <class Point>
Chart gridChart(uint32_t columns, uint32_t rows, vec2 size, Point point) {
  Chart chart;
  chart.size = size;
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      point(u, v, chart.positions.emplace_back(), chart.normals.emplace_back());
      chart.atlas.push_back({float(u), float(v)});
    }
  chart.texcoords = chart.atlas;
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = j * (columns + 1) + i, d = a + columns + 1;
      addQuad(chart, a, a + 1, d + 1, d);
    }
  return chart;
}

}  // namespace boxlight::data
