// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "bake/scene/scene.h"

namespace boxlight {

/// A scene's triangles as charting sees them: welded by position, with neighbours over the edges that a chart
/// may cross.
struct ChartMesh {
  std::vector<std::array<uint32_t, 3>> position;   ///< [triangle][corner], number of the welded position
  std::vector<std::array<uint32_t, 3>> neighbour;  ///< [triangle][k] over corners k, k + 1, or asset::kNone
  std::vector<dvec3> normal;                       ///< unit, of the front
  std::vector<dvec3> centroid;
  std::vector<double> area;         ///< square metres
  std::vector<float> scale;         ///< Scene::texelScales, per triangle
  std::vector<dvec3> positions;     ///< welded
  std::vector<uint32_t> materials;  ///< per triangle

  size_t size() const { return position.size(); }
  double edgeLength(uint32_t triangle, int k) const {
    return glm::distance(positions[position[triangle][k]], positions[position[triangle][(k + 1) % 3]]);
  }
};

/// A chart may cross an edge that two triangles of one material and one texel scale run through in opposite
/// directions, if their planes or their shading normals differ by no more than 30 degrees. Where more than
/// two triangles share an edge, those of the same vertices belong together, then the flattest pair.
ChartMesh makeChartMesh(const Scene& scene);

}  // namespace boxlight
