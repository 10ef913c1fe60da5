// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/scene.h"

namespace boxlight {

std::vector<float> texelScaleOfTriangles(const Scene& scene) {
  std::vector<float> scale(scene.triangles.size(), 1.0f);
  for (size_t i = 0; i < scene.texelScales.size(); ++i) {
    const bool last = i + 1 == scene.texelScales.size();
    const size_t end = last ? scale.size() : scene.texelScales[i + 1].firstTriangle;
    std::fill(scale.begin() + scene.texelScales[i].firstTriangle, scale.begin() + ptrdiff_t(end),
              scene.texelScales[i].scale);
  }
  return scale;
}

}  // namespace boxlight
