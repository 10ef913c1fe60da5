// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/view_extremes.h"

#include <cmath>

#include "common/light/light_map.h"
#include "common/light/relight.h"

namespace boxlight::test {

Box ViewExtremes::boxOf(const GridBox& b, Rgb energy) {
  return {float(b.u) / 65536, float(b.v) / 65536, float(b.du) / 65536, float(b.dv) / 65536, energy};
}

Camera ViewExtremes::cameraAlong(vec3 eye, vec3 forward, uint32_t edge, float degrees) {
  Camera camera = cameraAbove(edge);
  camera.eye = eye;
  camera.forward = glm::normalize(forward);
  const vec3 any = std::abs(camera.forward.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
  camera.right = glm::normalize(glm::cross(camera.forward, any));
  camera.up = glm::cross(camera.right, camera.forward);
  camera.tanHalfFov = std::tan(0.5f * degrees * kPi / 180.0f);
  return camera;
}

Camera ViewExtremes::cameraAt(vec3 eye, uint32_t edge, float degrees) {
  return cameraAlong(eye, -eye, edge, degrees);
}

double ViewExtremes::worstAgainstOracle(const asset::AssetReader& reader, const Image& environment) {
  gpu::FrameRenderer renderer(*device_, reader, environment, settings_);
  const SummedArea lights(makeLightMap(environment, settings_.lightSize));
  Relighter relighter(reader);
  const auto shaded = renderer.readShaded();
  const auto visible = renderer.readVisible();
  EXPECT_GT(visible.size(), 0u);
  const bool isGlossy = reader.asset().tiles.front().glossyBoxes > 0;
  double worst = 0;
  for (const auto& [r, glossy] : visible) {
    const TexelRadiance exact = relighter.relight(r, settings_.camera.eye, lights);
    for (int c = 0; c < 3; ++c) {
      const auto error = [](double found, double truth) {
        EXPECT_TRUE(std::isfinite(found));  // max() does not see NaN
        return std::abs(found - truth) / std::max(std::abs(truth), 1e-12);
      };
      worst = std::max(worst, error(double(shaded[2 * r][c]), exact.diffuse[c]));
      if (glossy && isGlossy) worst = std::max(worst, error(double(shaded[2 * r + 1][c]), exact.glossy[c]));
    }
  }
  return worst;
}

}  // namespace boxlight::test
