// SPDX-License-Identifier: Apache-2.0
#include "common/image/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"

namespace boxlight {
namespace {

void expectNear(vec3 a, vec3 b, float tolerance = 1e-6f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "component " << c;
}

CameraOptions lookingAt(vec3 eye, vec3 target) {
  CameraOptions options;
  options.eye = eye;
  options.target = target;
  return options;
}

Camera cameraOf(const CameraOptions& options) { return makeCamera(options, vec3(-1.0f), vec3(1.0f)); }

TEST(Camera, CornerRays) {
  CameraOptions options = lookingAt({0, 0, 5}, {0, 0, 0});
  options.fovDegrees = 90.0f;
  options.size = {200, 100};
  const Camera camera = cameraOf(options);
  expectNear(camera.direction({100, 50}), {0, 0, -1});
  expectNear(camera.direction({0, 0}), glm::normalize(vec3(-2, 1, -1)));      // top left
  expectNear(camera.direction({200, 0}), glm::normalize(vec3(2, 1, -1)));     // top right
  expectNear(camera.direction({0, 100}), glm::normalize(vec3(-2, -1, -1)));   // bottom left
  expectNear(camera.direction({200, 100}), glm::normalize(vec3(2, -1, -1)));  // bottom right
  EXPECT_NEAR(glm::length(camera.direction({13.7f, 61.2f})), 1.0f, 1e-6f);
}

TEST(Camera, FovIsVertical) {
  CameraOptions options = lookingAt({0, 0, 0}, {1, 0, 0});
  options.fovDegrees = 40.0f;
  options.size = {50, 400};
  const Camera camera = cameraOf(options);
  const float angle = std::acos(glm::dot(camera.direction({25, 0}), camera.direction({25, 400})));
  EXPECT_NEAR(angle, 40.0f * kPi / 180.0f, 1e-5f);
  expectNear(camera.direction({50, 200}), glm::normalize(vec3(1, 0, std::tan(20.0f * kPi / 180.0f) / 8.0f)));
}

TEST(Camera, BasisIsOrthonormalAndRightHanded) {
  const Camera camera = cameraOf(lookingAt({3, 2, -4}, {0.5f, 0, 1}));
  EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0f, 1e-6f);
  expectNear(glm::cross(camera.right, camera.up), -camera.forward);
  EXPECT_GT(camera.up.y, 0.0f);
}

/// Does every corner of the box project inside the picture?
void expectFrames(CameraOptions options, vec3 low, vec3 high) {
  const Camera camera = makeCamera(options, low, high);
  float largest = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p = glm::mix(low, high, vec3(corner & 1, corner >> 1 & 1, corner >> 2)) - camera.eye;
    const float depth = glm::dot(p, camera.forward) * camera.tanHalfFov;
    ASSERT_GT(depth, 0.0f);
    const float aspect = float(options.size.x) / float(options.size.y);
    largest = std::max({largest, std::abs(glm::dot(p, camera.up)) / depth,
                        std::abs(glm::dot(p, camera.right)) / depth / aspect});
  }
  EXPECT_LE(largest, 1.0f);
  EXPECT_GT(largest, 0.5f) << "the object should fill a good part of the picture";
}

TEST(Camera, FramesTheBounds) {
  CameraOptions options;
  expectFrames(options, {-1, -1, -1}, {1, 1, 1});
  expectFrames(options, {100, 5, -3}, {100.02f, 5.01f, -2.99f});
  options.size = {200, 800};
  expectFrames(options, {-1, -2, -1}, {1, 2, 1});
  options.size = {800, 200};
  options.fovDegrees = 100.0f;
  expectFrames(options, {-1, -2, -1}, {1, 2, 1});
}

TEST(Camera, DefaultEyeIsInFrontAndAbove) {
  const Camera camera = makeCamera({}, vec3(-1.0f), vec3(1.0f));
  EXPECT_GT(camera.eye.z, 0.0f);
  EXPECT_GT(camera.eye.y, 0.0f);
  expectNear(camera.forward, -glm::normalize(camera.eye));
}

TEST(Camera, DegenerateOptions) {
  expectNear(cameraOf(lookingAt({0, 5, 0}, {0, 0, 0})).up, {0, 0, -1});
  expectNear(cameraOf(lookingAt({0, -5, 0}, {0, 0, 0})).up, {0, 0, -1});
  CameraOptions along = lookingAt({5, 0, 0}, {0, 0, 0});
  along.up = {-2, 0, 0};
  expectNear(cameraOf(along).up, {0, 1, 0});
  EXPECT_TRUE(std::isfinite(makeCamera({}, vec3(2.0f), vec3(2.0f)).eye.x)) << "a single point";

  EXPECT_THROW(cameraOf(lookingAt({1, 2, 3}, {1, 2, 3})), Error);
  CameraOptions noUp = lookingAt({5, 0, 0}, {0, 0, 0});
  noUp.up = vec3(0.0f);
  EXPECT_THROW(cameraOf(noUp), Error);
}

TEST(Camera, OptionsParse) {
  CLI::App app;
  CameraOptions options;
  addCameraOptions(app, options);
  app.parse("--eye 1,2,3 --fov 60 --size 320x200");
  EXPECT_EQ(options.eye.value(), vec3(1, 2, 3));
  EXPECT_FALSE(options.target.has_value());
  EXPECT_EQ(options.fovDegrees, 60.0f);
  EXPECT_EQ(options.size, uvec2(320, 200));
  EXPECT_THROW(app.parse("--fov 0"), CLI::ValidationError);
  EXPECT_THROW(app.parse("--fov 180"), CLI::ValidationError);
  EXPECT_THROW(app.parse("--fov nan"), CLI::ParseError);
}

}  // namespace
}  // namespace boxlight
