// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/texel_density.h"

#include <algorithm>
#include <cmath>

#include "bake/scene/mesh.h"

namespace boxlight {
namespace {

constexpr double kLeftOut = 0.01;  // of the surface, at either end

struct Sample {
  double density, area;
};

double atFraction(const std::vector<Sample>& sorted, double total, double fraction) {
  double sum = 0;
  for (const Sample& sample : sorted) {
    sum += sample.area;
    if (sum >= fraction * total) return sample.density;
  }
  return sorted.empty() ? 0 : sorted.back().density;
}

}  // namespace

TexelDensity measureDensity(const Scene& scene, uint32_t atlasSize) {
  const std::vector<float> scale = texelScaleOfTriangles(scene);
  std::vector<Sample> samples;
  TexelDensity result;
  double total = 0;
  for (size_t t = 0; t < scene.triangles.size(); ++t) {
    dvec3 p[3];
    dvec2 uv[3];
    for (int k = 0; k < 3; ++k) {
      const asset::Vertex& vertex = scene.vertices[scene.triangles[t].vertex[k]];
      p[k] = positionOf(vertex);
      uv[k] = {vertex.atlasUv[0], vertex.atlasUv[1]};
    }
    const dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double inAtlas = 0.5 * std::abs(a.x * b.y - a.y * b.x);
    const double inWorld = 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    if (!(inWorld > 0)) continue;
    samples.push_back({atlasSize * std::sqrt(inAtlas / inWorld) / scale[t], inWorld});
    result.coverage += inAtlas;
    result.mean += samples.back().density * inWorld;
    total += inWorld;
  }
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.density < b.density; });
  result.least = atFraction(samples, total, kLeftOut);
  result.most = atFraction(samples, total, 1 - kLeftOut);
  result.mean /= std::max(total, 1e-300);
  return result;
}

}  // namespace boxlight
