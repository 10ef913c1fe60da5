// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/light/ggx.h"
#include "tests/known/programs.h"

using namespace boxlight;
using test::objectMean;
using test::picture;
using test::Shot;
using test::tolerance;
using test::Way;

namespace {

/// Directional albedo of a white metal: int D V F n.l dl with F = 1, by midpoint quadrature over visible
/// normals.
double whiteMetalAlbedo(float roughness, float nDotV) {
  const float alpha = ggx::alphaOf(roughness);
  const vec3 view(std::sqrt(1 - nDotV * nDotV), 0, nDotV);
  constexpr int kSteps = 1024;
  double sum = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const vec3 half =
        ggx::sampleVisibleNormal(view, alpha, (vec2(i % kSteps, i / kSteps) + 0.5f) / float(kSteps));
    const vec3 light = glm::reflect(-view, half);
    if (light.z > 0)
      sum += double(ggx::visibility(light.z, view.z, alpha)) * 4 * light.z * view.z /
             ggx::masking(view.z, alpha);
  }
  return sum / kSteps / kSteps;
}

}  // namespace

class Furnace : public ::testing::TestWithParam<Way> {};

TEST_P(Furnace, ConvexWhiteSphereIsOne) {
  const Image image = picture(GetParam(), {"sphere", "white", "--size 48x48 --eye 1,1,3.5 --target 0,0,0"});
  const Rgb mean = objectMean(image);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], 1, tolerance(GetParam()));
}

TEST_P(Furnace, ConcaveWhiteBowlIsOneInsideAndOut) {
  const Shot inside{"bowl", "white", "--size 48x48 --eye 0.4,3.5,0.9 --target 0,-0.4,0"},
      outside{"bowl", "white", "--size 48x48 --eye 1,-2.5,2 --target 0,-0.4,0"};
  EXPECT_NEAR(objectMean(picture(GetParam(), inside)).x, 1, tolerance(GetParam()));
  EXPECT_NEAR(objectMean(picture(GetParam(), outside)).x, 1, tolerance(GetParam()));
}

TEST_P(Furnace, WhiteMetalIsItsDirectionalAlbedo) {
  for (const char* roughness : {"0.1", "0.4", "1"})
    for (float nDotV : {0.15f, 0.5f, 0.95f}) {
      // Far away and through a narrow lens n.v is the same in every pixel.
      const std::string eye = fmt::format("--size 48x48 --eye {},{},0 --target 0,0,0 --fov 0.4",
                                          100 * std::sqrt(1 - nDotV * nDotV), 100 * nDotV);
      const Image image =
          picture(GetParam(), {fmt::format("plane --set metallic=1 --set roughness={}", roughness), "white",
                               eye, "--atlas 4 --paths 4096", "--spp 128"});
      const double expected = whiteMetalAlbedo(std::stof(roughness), nDotV);
      EXPECT_NEAR(objectMean(image).y / expected, 1, tolerance(GetParam()))
          << "roughness " << roughness << ", n.v " << nDotV;
    }
}

/// All of the lobe is made at the pixel: nothing hides any of it.
TEST(SplitFurnace, WhiteMetalInTheOpenIsItsDirectionalAlbedo) {
  for (const char* roughness : {"0.1", "0.7"})
    for (float nDotV : {0.15f, 0.7f}) {
      const std::string eye = fmt::format("--size 48x48 --eye {},{},0 --target 0,0,0 --fov 0.4",
                                          100 * std::sqrt(1 - nDotV * nDotV), 100 * nDotV);
      const Image image =
          picture(Way::baked, {fmt::format("plane --set metallic=1 --set roughness={}", roughness), "white",
                               eye, "--atlas 4 --paths 64 --scheme split"});
      EXPECT_NEAR(objectMean(image).y / whiteMetalAlbedo(std::stof(roughness), nDotV), 1, 0.01)
          << "roughness " << roughness << ", n.v " << nDotV;
    }
}

/// The ground hides half of the ball's lobes; the light comes from one side.
TEST(SplitFurnace, MetalOnTheGroundIsAsBrightAsTheTruth) {
  for (const char* roughness : {"0.1", "0.5"}) {
    const Shot shot{fmt::format("sphere_on_ground --set metallic=1 --set roughness={}", roughness), "half",
                    "--size 96x96 --eye 2.5,2,3 --target 0,0.5,0 --fov 18",
                    "--atlas 48 --paths 128 --scheme split", "--spp 512"};
    const double baked = objectMean(picture(Way::baked, shot)).y,
                 truth = objectMean(picture(Way::truth, shot)).y;
    EXPECT_NEAR(baked / truth, 1, tolerance(Way::baked)) << "roughness " << roughness;
  }
}

INSTANTIATE_TEST_SUITE_P(, Furnace, ::testing::Values(Way::truth, Way::baked),
                         [](const auto& way) { return way.param == Way::truth ? "truth" : "baked"; });
