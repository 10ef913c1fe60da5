// SPDX-License-Identifier: Apache-2.0
// Which samples of a pixel are shaded as one: those of one smooth surface, whatever triangles it is cut into.
#include <cmath>

#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

class FragmentTest : public GpuTest {
 protected:
  Image draw(const asset::AssetReader& reader, const Image& environment, uint32_t samples) {
    settings_.samples = samples;
    return gpu::FrameRenderer(*device_, reader, environment, settings_).picture();
  }

  gpu::FrameSettings settings_;
  Square square_;
};

/// The diagonal of the square runs through the centres of pixels. A lobe this sharp under a small sun is
/// nowhere near linear there.
TEST_F(FragmentTest, TrianglesOfASmoothSurfaceAreShadedAsOne) {
  settings_.camera = cameraAbove(32);
  settings_.camera.eye.y *= 0.5f;
  square_.material.metallic = 1;
  square_.material.roughness = 0.2f;
  square_.material.specular = 1;
  square_.glossyBoxes = 2;
  square_.visibility = [](uint32_t) {
    VisibilityMap map;
    for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
      for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) map.setVisible(x, y);
    return map;
  };
  const asset::Asset asset = square_.makeAsset();
  const uint32_t diffuse = asset.diffuseStream();
  const auto reader = writeSynthetic(file("sharp.ptb"), asset, [&](uint32_t stream, uint32_t, uint32_t slot) {
    return slot == 0 && stream != diffuse ? packHiddenPart(0) : packBox({0, 0, 1, 1, Rgb(0.0f)});
  });
  Image sun = constantEnvironment({256, 128}, Rgb(0.1f));
  for (const uint32_t x : {30u, 31u})
    for (uint32_t c = 0; c < 3; ++c) sun.at(x, 12)[c] = 300;
  const Image once = draw(reader, sun, 1), four = draw(reader, sun, 2);
  float brightest = 0, darkest = 1e9f;
  for (uint32_t y = 1; y + 1 < 32; ++y)
    for (uint32_t x = 1; x + 1 < 32; ++x) {
      const float expected = once.at(x, y)[0];
      EXPECT_NEAR(four.at(x, y)[0], expected, 1e-3f * expected) << x << ' ' << y;
      brightest = std::max(brightest, expected), darkest = std::min(darkest, expected);
    }
  EXPECT_GT(brightest, 2 * darkest);
}

/// Two cells of one material whose vertices are their own, and on other parts of the atlas: a chart's border.
TEST_F(FragmentTest, BordersOfChartsKeepEverySampleItsOwn) {
  settings_.camera = cameraAbove(31);  // the border at x = 0 runs through the middle of column 15
  square_.cellEdge = 2;
  square_.cells.resize(4, square_.material);
  asset::Asset asset = square_.makeAsset();
  for (auto& triangle : asset.triangles) triangle.material = 0;
  for (size_t v = 0; v < asset.vertices.size(); ++v)
    asset.vertices[v].atlasUv[0] = v / 4 % 2 == 0 ? 0.25f : 0.75f;
  const auto reader = writeSynthetic(file("charts.ptb"), asset, [](uint32_t, uint32_t record, uint32_t) {
    return packBox({0, 0, 1, 1, Rgb(record % 8 < 4 ? 1.0f : 0.25f)});
  });
  const Image picture = draw(reader, constantEnvironment({64, 32}, Rgb(1)), 2);
  for (uint32_t y = 1; y + 1 < 31; ++y) {
    const float left = picture.at(10, y)[0], right = picture.at(20, y)[0];
    EXPECT_NEAR(right, 0.25f * left, 1e-3f * left);
    EXPECT_NEAR(picture.at(15, y)[0], 0.5f * (left + right), 1e-3f * left) << y;
  }
}

}  // namespace
}  // namespace boxlight
