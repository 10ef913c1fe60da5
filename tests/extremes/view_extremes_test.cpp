// SPDX-License-Identifier: Apache-2.0
// Whole frames at the ends of what cameras, kernels and places can be, against the oracle and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/view_sphere.h"
#include "tests/extremes/extreme_maps.h"
#include "tests/extremes/view_extremes.h"

namespace boxlight::test {
namespace {

/// A constant environment through all of ptview: every pixel is 1, whatever box its record has.
TEST_F(ViewExtremes, ConstantLightIsExactInThePicture) {
  std::vector<GridBox> boxes;
  for (const BoxKind& kind : boxKinds())
    boxes.insert(boxes.end(), kind.boxes.begin(), kind.boxes.begin() + 2);
  Square square;
  square.atlasEdge = 32;
  square.viewFrequency = 1;
  const auto reader = square.write(file("constant.ptb"), [&](uint32_t, uint32_t record, uint32_t) {
    return boxOf(boxes[record % boxes.size()], Rgb(1.0f, 0.5f, 2.0f));
  });
  settings_.camera = cameraAbove(64);
  for (const auto scheme : {gpu::SatScheme::compact, gpu::SatScheme::exact}) {
    settings_.satScheme = scheme;
    gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(1)), settings_);
    const auto expectOne = [&](float scale, const char* what) {
      renderer.run();
      double worst = 0;
      for (uint32_t y = 1; y < 63; ++y)
        for (uint32_t x = 1; x < 63; ++x) {
          const float* p = renderer.picture().at(x, y);
          worst = std::max({worst, std::abs(p[0] / scale - 1.0), std::abs(p[1] / scale / 0.5 - 1.0),
                            std::abs(p[2] / scale / 2.0 - 1.0)});
        }
      EXPECT_LT(worst, 1e-5) << what;
    };
    expectOne(1.0f, "level");
    const auto turn = [&](float degrees, EnvironmentTilt tilt, float intensity) {
      gpu::FrameSettings turned = renderer.settings();
      turned.environmentDegrees = degrees;
      turned.environmentTilt = tilt;
      turned.environmentIntensity = intensity;
      renderer.set(turned);
    };
    turn(33.3f, {}, 1.0f);
    expectOne(1.0f, "turned");
    turn(-200.0f, {37.0f, -12.0f}, 1.0f);
    expectOne(1.0f, "tilted");
    turn(0.0f, {}, 1e6f);
    expectOne(1e6f, "brighter");
  }
}

TEST_F(ViewExtremes, WeightsOverTwelveDecades) {
  Square square;
  square.atlasEdge = 16;
  square.diffuseBoxes = 13;
  square.viewFrequency = 1;
  std::mt19937 random(6);
  const auto boxes = boxKinds().back().boxes;
  const auto reader = square.write(file("decades.ptb"), [&](uint32_t, uint32_t record, uint32_t slot) {
    const float energy = std::max(65504.0f * std::pow(10.0f, -float(slot)), 6e-8f);
    return boxOf(boxes[(record + 7 * slot) % boxes.size()], Rgb(energy));
  });
  settings_.camera = cameraAbove(32);
  for (const ExtremeMap& map : extremeMaps()) {
    if (map.name == "sun of 1e9" || map.name == "one lit texel at the south pole") continue;
    EXPECT_LT(worstAgainstOracle(reader, map.image), 1e-4) << map.name;
  }
}

/// On a vertex of the views' sphere one kernel is all there is; on an edge two, at a centre three alike.
TEST_F(ViewExtremes, ViewsOnVerticesEdgesAndCentres) {
  Square square;
  square.atlasEdge = 1;
  square.glossyBoxes = 4;
  const auto boxes = boxKinds().back().boxes;
  const auto reader = square.write(file("views.ptb"), [&](uint32_t stream, uint32_t, uint32_t slot) {
    return boxOf(boxes[(stream + 23 * slot) % boxes.size()], Rgb(1.0f / float(1 + (stream + slot) % 5)));
  });
  const ViewSphere sphere(3);
  std::vector<vec3> views = {{0, 1, 0}};
  for (uint32_t v = 0; v < sphere.viewCount() && views.size() < 4; v += 5)
    if (sphere.directions()[v].y > 0.2f) views.push_back(sphere.directions()[v]);
  const ViewBlend blend = sphere.locate(glm::normalize(vec3(0.3f, 0.8f, -0.2f)));
  const vec3 a = sphere.directions()[blend.view[0]], b = sphere.directions()[blend.view[1]],
             c = sphere.directions()[blend.view[2]];
  views.insert(views.end(), {glm::normalize(a + b), glm::normalize(b + c), glm::normalize(a + b + c)});
  const Image sky = extremeMaps()[1].image;
  for (const vec3& view : views) {
    settings_.camera = cameraAt(4.0f * view, 16, 40.0f);
    EXPECT_LT(worstAgainstOracle(reader, sky), 1e-4) << view.x << " " << view.y << " " << view.z;
  }
}

/// Grazing, a thousandth of the object away, and a million times its size away.
TEST_F(ViewExtremes, GrazingNearAndFarCameras) {
  Square square;
  square.atlasEdge = 8;
  square.glossyBoxes = 3;
  const auto boxes = boxKinds().back().boxes;
  const auto reader = square.write(file("cameras.ptb"), [&](uint32_t stream, uint32_t record, uint32_t slot) {
    return boxOf(boxes[(stream + 5 * record + 23 * slot) % boxes.size()], Rgb(1.0f));
  });
  const struct {
    vec3 eye;
    float degrees;
  } cameras[] = {{{3.0f, 0.03f, 0.0f}, 3.0f}, {{0.0f, 1e-3f, 0.0f}, 90.0f}, {{3e5f, 1e6f, 0.0f}, 1e-4f}};
  for (const auto& [eye, degrees] : cameras) {
    settings_.camera = cameraAt(eye, 48, degrees);
    SCOPED_TRACE(eye.y);
    EXPECT_LT(worstAgainstOracle(reader, extremeMaps()[1].image), 1e-4) << eye.y;
    gpu::FrameRenderer renderer(*device_, reader, extremeMaps()[2].image, settings_);
    for (const float value : renderer.picture().pixels) ASSERT_TRUE(std::isfinite(value)) << eye.y;
  }
}

/// An asset as the bake writes it 1e5 sizes from the origin, with triangles that have no area.
TEST_F(ViewExtremes, FarFromTheOriginAndWithoutArea) {
  Square square;
  square.atlasEdge = 4;
  asset::Asset asset = square.makeAsset();
  const vec3 place(1e5f, 0.0f, -1e5f);
  for (auto& vertex : asset.vertices)
    for (int k = 0; k < 3; ++k) vertex.position[k] += place[k];
  for (auto& record : asset.records)
    for (int k = 0; k < 3; ++k) record.position[k] += place[k];
  for (int k = 0; k < 3; ++k) asset.info.boundsMin[k] += place[k], asset.info.boundsMax[k] += place[k];
  asset.triangles.push_back({{0, 0, 1}, 0});
  asset.triangles.push_back({{2, 2, 2}, 0});
  const auto reader = writeSynthetic(file("far.ptb"), asset, [&](uint32_t, uint32_t, uint32_t) {
    return packBox({0.1f, 0.1f, 0.5f, 0.5f, Rgb(0.5f)});
  });
  settings_.camera = cameraAbove(32);
  settings_.camera.eye += place;
  settings_.background = false;
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({16, 8}, Rgb(1)), settings_);
  double covered = 0;
  for (uint32_t y = 0; y < 32; ++y)
    for (uint32_t x = 0; x < 32; ++x) {
      const float* p = renderer.picture().at(x, y);
      covered += double(p[3]);
      EXPECT_NEAR(p[0], 0.5f * p[3], 1e-5f) << x << " " << y;
    }
  EXPECT_GT(covered, 0.95 * 32 * 32);
}

/// A mirror of alpha 1e-4, shaded by the pixel, under a sun of 1e6: finite, and where it is lit, not above
/// the light; the same under a constant light, where it returns the lobe's albedo.
TEST_F(ViewExtremes, MirrorsOfTheLeastAlpha) {
  Square square;
  square.atlasEdge = 4;
  square.glossyBoxes = 2;
  square.visibility = [](uint32_t) {
    VisibilityMap open;
    for (uint32_t i = 0; i < VisibilityMap::kCells; ++i)
      open.setVisible(i % VisibilityMap::kColumns, i / VisibilityMap::kColumns);
    return open;
  };
  square.material.metallic = 1;
  square.material.specular = 1;
  square.material.roughness = 0.01f;
  const asset::Asset asset = square.makeAsset();
  const auto reader =
      writeSynthetic(file("mirror.ptb"), asset, [&](uint32_t stream, uint32_t, uint32_t slot) {
        return slot == 0 && stream != asset.diffuseStream() ? packHiddenPart(0.0f)
                                                            : packBox({0, 0, 1, 1, Rgb(0.0f)});
      });
  for (const vec3 eye : {vec3(0, 4, 0), vec3(3, 1, 1), vec3(4, 0.01f, 0)}) {
    settings_.camera = cameraAt(eye, 32, 30.0f);
    settings_.background = false;
    gpu::FrameRenderer renderer(*device_, reader, extremeMaps()[2].image, settings_);
    for (const float value : renderer.picture().pixels) {
      ASSERT_TRUE(std::isfinite(value));
      ASSERT_LE(value, 1.001e6f);
      ASSERT_GE(value, -1e-3f);
    }
    const Image constant = constantEnvironment({64, 32}, Rgb(2));
    renderer.set(settings_, &constant);
    renderer.run();
    for (uint32_t y = 0; y < 32; ++y)
      for (uint32_t x = 0; x < 32; ++x) {
        const float* p = renderer.picture().at(x, y);
        if (p[3] < 1.0f) continue;
        EXPECT_NEAR(p[1], 2.0f, 0.03f) << x << " " << y;
      }
  }
}

}  // namespace
}  // namespace boxlight::test
