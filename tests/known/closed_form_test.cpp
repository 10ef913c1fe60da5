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

// One box of a kernel may be a few percent off at one direction: the mean over azimuths, under which the
// answer does not change, is held.
TEST_P(ClosedForm, OneTexelSunGivesRhoECosOverPi) {
  const Image sun = data::makeEnvironment("texel_sun");
  // The truth interpolates the texel bilinearly, the light map takes it as a square; their irradiances differ
  // by less than 1e-3 here, far from the poles.
  const double v0 = double(data::kLitTexel.y) / sun.height, v1 = double(data::kLitTexel.y + 1) / sun.height;
  const double radiance = sun.at(data::kLitTexel.x, data::kLitTexel.y)[0];
  const double projected =
      kPiDouble / sun.width * (std::pow(std::sin(kPiDouble * v1), 2) - std::pow(std::sin(kPiDouble * v0), 2));
  const double expected = 0.5 * radiance * projected / kPiDouble;
  double mean = 0;
  for (int degrees = 0; degrees < 360; degrees += 60)
    mean +=
        objectMean(picture(GetParam(),
                           {"plane --set albedo=0.5", "texel_sun",
                            fmt::format("--size 48x48 --eye 1,3,1 --target 0,0,0 --env-rotation {}", degrees),
                            "--atlas 4 --paths 4096 --boxes 32", "--spp 64"}))
            .x /
        6;
  EXPECT_NEAR(mean / expected, 1, tolerance(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(, ClosedForm, ::testing::Values(Way::truth, Way::baked),
                         [](const auto& way) { return way.param == Way::truth ? "truth" : "baked"; });
