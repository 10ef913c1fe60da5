// SPDX-License-Identifier: Apache-2.0
// A thin film over a split lobe: its own colour under every view, by an integral that shares nothing with the
// pixel's but the film's series.
#include <cmath>

#include "common/light/ggx.h"
#include "tests/runtime/pixel_model.h"
#include "tests/runtime/split_scene.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

class FilmTest : public GpuTest {
 protected:
  /// Views from n.v .07 to 1.
  static Camera lowCamera() {
    Camera camera = cameraAbove(24);
    camera.eye = {0, 0.1f, 0};
    camera.tanHalfFov = 10;
    return camera;
  }

  asset::AssetReader write(const Finish& finish) const {
    Square square;
    square.atlasEdge = kEdge;
    square.glossyBoxes = 2;
    square.diffuseBoxes = 0;
    square.material = finish.material;
    square.extensions = {finish.extension};
    square.visibility = [](uint32_t) { return openMap(); };
    asset::Asset asset = square.makeAsset();
    for (uint32_t s = 0; s < asset.diffuseStream(); ++s)
      for (size_t t = 0; t < asset.tiles.size(); ++t) asset.streamMasks[s * asset.tiles.size() + t] = 0;
    return writeSynthetic(file("film.ptb"), asset, [](uint32_t, uint32_t, uint32_t) { return PackedBox{}; });
  }

  /// Over visible normals.
  static dvec3 reflected(const Finish& finish, double cosine) {
    constexpr int kSide = 24;
    const vec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
    const vec2 alpha(finish.material.roughness * finish.material.roughness);
    dvec3 sum(0);
    for (int i = 0; i < kSide * kSide; ++i) {
      const vec2 random = (vec2(float(i % kSide), float(int(i / kSide))) + 0.5f) / float(kSide);
      const vec3 half = ggx::sampleVisibleNormal(view, alpha, random);
      const vec3 light = 2 * glm::dot(view, half) * half - view;
      if (!(light.z > 0)) continue;
      const float weight =
          ggx::visibility(light, view, alpha) * 4 * light.z * view.z / ggx::masking(view, alpha);
      sum += dvec3(weight * baseFresnel(finish.material, finish.extension, glm::dot(view, half)));
    }
    return sum / double(kSide * kSide);
  }

  /// Root of the mean square over pixels and channels.
  double difference(const Finish& finish) {
    gpu::FrameSettings settings;
    settings.camera = lowCamera();
    settings.samples = 1;
    gpu::FrameRenderer renderer(*device_, write(finish), constantEnvironment({64, 32}, Rgb(1)), settings);
    double squares = 0;
    int count = 0;
    for (uint32_t y = 0; y < settings.camera.size.y; ++y)
      for (uint32_t x = 0; x < settings.camera.size.x; ++x, ++count) {
        const double cosine = -double(glm::normalize(settings.camera.direction(vec2(x, y) + 0.5f)).y);
        const float* pixel = renderer.picture().at(x, y);
        const dvec3 error = dvec3(pixel[0], pixel[1], pixel[2]) - reflected(finish, cosine);
        squares += glm::dot(error, error) / 3;
      }
    return std::sqrt(squares / count);
  }
};

TEST_F(FilmTest, UnderGrazingViewsItKeepsItsColour) {
  for (const float roughness : {0.1f, 0.25f, 0.5f}) {
    EXPECT_LT(difference(filmedMetal(roughness)), 0.02) << roughness;
    EXPECT_LT(difference(filmedVarnish(roughness)), 0.02) << roughness;
  }
}

}  // namespace
}  // namespace boxlight
