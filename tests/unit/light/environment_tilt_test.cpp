// SPDX-License-Identifier: Apache-2.0
#include "common/light/environment_tilt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/environment.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "common/light/summed_area.h"

namespace boxlight {
namespace {

void expectNear(dvec3 a, dvec3 b) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-7);
}

TEST(EnvironmentTilt, RollThenPitchThenRotation) {
  // What stood at the image's +X, +Y, +Z now stands at...
  const auto stands = [](dvec3 inImage, EnvironmentTilt tilt, float rotation) {
    return glm::transpose(worldToEnvironment(tilt, rotation)) * inImage;
  };
  expectNear(stands({1, 0, 0}, {0, 90}, 0), {0, 1, 0});    // roll takes +X to +Y
  expectNear(stands({0, 1, 0}, {90, 0}, 0), {0, 0, 1});    // pitch takes +Y to +Z
  expectNear(stands({0, 0, 1}, {0, 0}, 90), {1, 0, 0});    // rotation takes +Z to +X
  expectNear(stands({1, 0, 0}, {90, 90}, 90), {1, 0, 0});  // +X to +Y, to +Z, to +X
  expectNear(untilt({90, 90}) * dvec3(0, 0, 1), {1, 0, 0});
}

TEST(EnvironmentTilt, LevelRotationIsTheOffset) {
  for (const float degrees : {0.0f, 37.0f, -120.0f}) {
    const vec3 d = glm::normalize(vec3(0.3f, 0.5f, -0.8f));
    const vec2 uv = directionToUv(vec3(worldToEnvironment({}, degrees) * dvec3(d)));
    const float u = directionToUv(d).x + environmentOffset(degrees);
    EXPECT_NEAR(uv.x, u - std::floor(u), 1e-6f);
  }
}

TEST(EnvironmentTilt, ConstantStaysConstant) {
  Image image = makeImage(37, 23, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 0.7f);
  for (const float value : makeTiltedMap(image, {64, 32}, {33, -71}).pixels) EXPECT_NEAR(value, 0.7f, 2e-7f);
}

/// A sky with a sun of one texel keeps the sun's energy to the rounding of floats, and puts it where it
/// belongs.
TEST(EnvironmentTilt, ASunKeepsItsEnergyAndItsPlace) {
  Image image = makeImage(256, 128, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 1.0f);
  const uvec2 place(37, 50);
  image.at(place.x, place.y)[1] = 1e6f;
  const EnvironmentTilt tilt{40, 25};
  const Image map = makeTiltedMap(image, {128, 64}, tilt);
  EXPECT_NEAR(totalEnergy(map).y / totalEnergy(image).y, 1.0, 2e-5);
  const vec3 sun = uvToDirection({(place.x + 0.5f) / 256.0f, (place.y + 0.5f) / 128.0f});
  const vec2 at = directionToUv(vec3(glm::transpose(untilt(tilt)) * dvec3(sun)));
  const SummedArea table(map);
  const double around = table.integrate(Rectangle{at.x - 0.012, at.y - 0.024, 0.024, 0.048}).y;
  EXPECT_NEAR(around / (1e6 * texelSolidAngles(256, 128)[place.y]), 1.0, 1e-3);
}

/// Box integrals of a tilted map against many directions of the image itself.
TEST(EnvironmentTilt, BoxesAgreeWithDirections) {
  Image image = makeImage(128, 64, 3);
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 128; ++x) {
      const vec3 d = uvToDirection({(float(x) + 0.5f) / 128, (float(y) + 0.5f) / 64});
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = 1.0f + 0.9f * d[c];
    }
  const EnvironmentTilt tilt{20, -65};
  const SummedArea table(makeTiltedMap(image, {128, 64}, tilt));
  for (const Rectangle& r :
       {Rectangle{0.1, 0.2, 0.3, 0.25}, Rectangle{0.8, 0.0, 0.5, 0.1}, Rectangle{0.0, 0.7, 1.0, 0.3}}) {
    // The integral of 1 + .9 d over the rectangle, d turned into the image.
    const dvec3 mean = untilt(tilt) * meanDirection(r.u0, r.v0, r.du, r.dv);
    const dvec3 found = table.integrate(r) / r.solidAngle();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], 1.0 + 0.9 * mean[c], 5e-3);
  }
}

}  // namespace
}  // namespace boxlight
