// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/light/environment_tilt.h"
#include "tests/known/programs.h"

using namespace boxlight;
using test::objectAt;
using test::picture;
using test::Way;

namespace {

/// The colours of the environment "axes".
Rgb axisColour(vec3 d) {
  const vec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0 ? Rgb(1, 0, 0) : Rgb(0, 1, 1);
  if (a.y >= a.z) return d.y > 0 ? Rgb(0, 1, 0) : Rgb(1, 0, 1);
  return d.z > 0 ? Rgb(0, 0, 1) : Rgb(1, 1, 0);
}

vec3 rotateY(vec3 d, float degrees) {
  const float c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  return {d.x * c + d.z * s, d.y, -d.x * s + d.z * c};
}

}  // namespace

class Orientation : public ::testing::TestWithParam<Way> {};

// Seen from each axis, the middle of a mirror-like sphere shows what lies behind the camera. Two rotations
// about +Y.
TEST_P(Orientation, AMirrorSphereShowsTheRightColourInSixDirections) {
  const vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int rotation : {0, 90})
    for (vec3 axis : axes) {
      const std::string up = axis.y == 0 ? "0,1,0" : "0,0,1";
      const Image image = picture(
          GetParam(),
          {"mirror_sphere", "axes",
           fmt::format("--eye {},{},{} --target 0,0,0 --up {} --fov 20 --env-rotation {} --size 33x33",
                       6 * axis.x, 6 * axis.y, 6 * axis.z, up, rotation),
           "--atlas 64 --paths 128 --boxes 8", "--spp 64"});
      const Rgb seen = objectAt(image, 16, 16), expected = axisColour(rotateY(axis, float(-rotation)));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c], expected[c], 0.2)
            << "from " << axis.x << axis.y << axis.z << ", rotation " << rotation << ", channel " << c;
    }
}

// The same under a tilted environment: rolled, pitched and turned by quarters.
TEST_P(Orientation, AMirrorSphereShowsATiltedEnvironment) {
  const struct {
    EnvironmentTilt tilt;
    float rotation;
  } turns[] = {{{90, 0}, 0}, {{90, 90}, 90}, {{0, -90}, 180}};
  for (const auto& [tilt, rotation] : turns)
    for (vec3 axis : {vec3(1, 0, 0), vec3(0, 0, 1)}) {
      const Image image = picture(
          GetParam(), {"mirror_sphere", "axes",
                       fmt::format("--eye {},{},{} --target 0,0,0 --fov 20 --env-pitch {} --env-roll {} "
                                   "--env-rotation {} --size 33x33",
                                   6 * axis.x, 6 * axis.y, 6 * axis.z, tilt.pitch, tilt.roll, rotation),
                       "--atlas 64 --paths 128 --boxes 8", "--spp 64"});
      const Rgb seen = objectAt(image, 16, 16),
                expected = axisColour(vec3(worldToEnvironment(tilt, rotation) * dvec3(axis)));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c], expected[c], 0.2)
            << "from " << axis.x << axis.y << axis.z << ", pitch " << tilt.pitch << ", channel " << c;
    }
}

INSTANTIATE_TEST_SUITE_P(, Orientation, ::testing::Values(Way::truth, Way::baked),
                         [](const auto& way) { return way.param == Way::truth ? "truth" : "baked"; });
