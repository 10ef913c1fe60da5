// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/light/light_domain.h"
#include "data/environments.h"
#include "tests/known/programs.h"

using namespace boxlight;
using test::objectMean;
using test::picture;
using test::tolerance;
using test::Way;

/// Of light that arrives straight, of which boxes keep the cosine; the disc's edge is sampled.
constexpr double kStraight = 2e-3;

class ClosedForm : public ::testing::TestWithParam<Way> {};

TEST_P(ClosedForm, LambertPlaneUnderAHalfBlackSkyIsHalfItsAlbedo) {
  const Image image =
      picture(GetParam(), {"plane --set albedo=0.8", "half", "--size 48x48 --eye 1,3,1 --target 0,0,0"});
  EXPECT_NEAR(objectMean(image).x / 0.4, 1, tolerance(GetParam()));
}

// A tall black wall at x = 0 hides the half of the hemisphere with x < 0; what is left of the white sky is
// 1/2 at every distance.
TEST_P(ClosedForm, PlaneBesideAnInfiniteWallIsHalf) {
  const Image image =
      picture(GetParam(), {"plane_wall", "white", "--size 48x48 --eye 1,2,0.001 --target 1,0,0 --fov 3",
                           "--atlas 64 --paths 1024 --boxes 8"});
  EXPECT_NEAR(objectMean(image).x / 0.5, 1, tolerance(GetParam()));
}

// Under the half-black sky the same wall hides nothing that shines, so the answer is the plane's own: a
// constant kernel would fail.
TEST_P(ClosedForm, TheWallHidesTheDarkHalf) {
  const Image image =
      picture(GetParam(), {"plane_wall", "half", "--size 48x48 --eye 1,2,0.001 --target 1,0,0 --fov 3",
                           "--atlas 64 --paths 1024 --boxes 8"});
  EXPECT_NEAR(objectMean(image).x / 0.5, 1, tolerance(GetParam()));
}

// A wall of height h at distance x hides (1 - x / sqrt(x^2 + h^2)) / 2 of the cosine-weighted hemisphere.
TEST_P(ClosedForm, PlaneBesideALowWall) {
  for (float x : {0.3f, 1.2f}) {
    const Image image =
        picture(GetParam(), {"plane_wall --set height=0.8", "white",
                             fmt::format("--size 48x48 --eye {},3,0.001 --target {},0,0 --fov 0.6", x, x),
                             "--atlas 128 --paths 512 --boxes 8"});
    EXPECT_NEAR(objectMean(image).x / (0.5 * (1 + x / std::hypot(x, 0.8))), 1, tolerance(GetParam()))
        << "at " << x;
  }
}

// A Lambert sphere: radiance rho E cos / pi, whose mean over the disc seen from the sun is 2/3 of rho E / pi,
// and 0 over the disc seen from the other side.
TEST_P(ClosedForm, OneTexelSunGivesRhoECosOverPi) {
  const Image sun = data::makeEnvironment("texel_sun");
  const vec2 uv = (vec2(data::kLitTexel) + 0.5f) / vec2(sun.width, sun.height);
  const double solidAngle = rectangleSolidAngle(1.0 / sun.width, double(data::kLitTexel.y) / sun.height,
                                                double(data::kLitTexel.y + 1) / sun.height);
  const double irradiance = sun.at(data::kLitTexel.x, data::kLitTexel.y)[0] * solidAngle;
  auto discMean = [&](float distance) {  // so far that the disc is an orthographic one
    const vec3 eye = distance * uvToDirection(uv);
    return objectMean(
               picture(GetParam(), {"sphere --set albedo=0.5", "texel_sun",
                                    fmt::format("--size 96x96 --eye {},{},{} --target 0,0,0 --fov 0.12",
                                                eye.x, eye.y, eye.z),
                                    "--atlas 48 --paths 64 --boxes 16", "--spp 64"}))
               .x /
           (0.5 * irradiance / kPiDouble);
  };
  const double lit = discMean(2000), dark = discMean(-2000);
  EXPECT_NEAR(dark / (2.0 / 3.0), 0, kStraight);
  EXPECT_NEAR(lit / (2.0 / 3.0), 1, kStraight);
}

// The same at one direction: a plane, where rho E cos / pi is the answer in every pixel.
TEST_P(ClosedForm, OneTexelSunOnAPlane) {
  const Image sun = data::makeEnvironment("texel_sun");
  const double v0 = double(data::kLitTexel.y) / sun.height, v1 = double(data::kLitTexel.y + 1) / sun.height;
  const double projected =
      kPiDouble / sun.width * (std::pow(std::sin(kPiDouble * v1), 2) - std::pow(std::sin(kPiDouble * v0), 2));
  const double expected = 0.5 * sun.at(data::kLitTexel.x, data::kLitTexel.y)[0] * projected / kPiDouble;
  for (int degrees : {0, 130}) {
    const Image image = picture(
        GetParam(), {"plane --set albedo=0.5", "texel_sun",
                     fmt::format("--size 48x48 --eye 1,3,1 --target 0,0,0 --env-rotation {}", degrees),
                     "--atlas 4 --paths 256 --boxes 8", "--spp 64"});
    EXPECT_NEAR(objectMean(image).x / expected, 1, kStraight) << "rotation " << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(, ClosedForm, ::testing::Values(Way::truth, Way::baked),
                         [](const auto& way) { return way.param == Way::truth ? "truth" : "baked"; });
