// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/camera_control.h"

#include <gtest/gtest.h>

#include "runtime/app/recording.h"

namespace boxlight::gpu {
namespace {

CameraOptions front() {
  CameraOptions camera;
  camera.target = vec3(1, 2, 3);
  camera.eye = vec3(1, 2, 8);
  return camera;
}

void expectNear(vec3 value, vec3 expected, float tolerance = 1e-4f) {
  EXPECT_LT(glm::length(value - expected), tolerance)
      << value.x << ' ' << value.y << ' ' << value.z << " for " << expected.x << ' ' << expected.y << ' '
      << expected.z;
}

TEST(CameraControl, OrbitKeepsTheDistance) {
  CameraOptions camera = front();
  orbit(camera, 90, 0);
  expectNear(*camera.eye, {6, 2, 3});
  orbit(camera, 0, 30);
  expectNear(*camera.eye, vec3(1, 2, 3) + 5.0f * vec3(std::sqrt(0.75f), 0.5f, 0));
  expectNear(*camera.target, {1, 2, 3});
}

TEST(CameraControl, OrbitStopsBeforeThePoleAndLeavesItAgain) {
  CameraOptions camera = front();
  for (int i = 0; i < 3; ++i) orbit(camera, 0, 170);
  const float height = (camera.eye->y - camera.target->y) / 5;
  EXPECT_NEAR(height, std::sin(89 * kPi / 180), 1e-5f);
  orbit(camera, 0, -89);
  expectNear(*camera.eye, {1, 2, 8}, 2e-3f);
}

TEST(CameraControl, FromThePoleItself) {
  CameraOptions camera = front();
  camera.eye = vec3(1, 7, 3);
  orbit(camera, 0, -45);
  EXPECT_NEAR(glm::length(*camera.eye - *camera.target), 5, 1e-4f);
  EXPECT_LT(camera.eye->y, 6);
}

TEST(CameraControl, PanMovesWhatIsAtTheTargetWithTheHand) {
  CameraOptions camera = front();
  pan(camera, {1, 0});  // a picture's height at the target's distance
  const float height = 2 * 5 * std::tan(20 * kPi / 180);
  expectNear(*camera.eye, {1 + height, 2, 8});
  expectNear(*camera.target, {1 + height, 2, 3});
}

TEST(CameraControl, ZoomNeverReachesTheTarget) {
  CameraOptions camera = front();
  zoom(camera, 2.5f);
  expectNear(*camera.eye, {1, 2, 5});
  for (int i = 0; i < 200; ++i) zoom(camera, 10);
  EXPECT_NE(*camera.eye, *camera.target);
  EXPECT_NO_THROW(makeCamera(camera, vec3(0), vec3(1)));
}

TEST(CameraControl, LookTurnsAboutTheEye) {
  CameraOptions camera = front();
  look(camera, 90, 0);
  expectNear(*camera.eye, {1, 2, 8});
  expectNear(*camera.target, {6, 2, 8});
  look(camera, 0, 45);
  EXPECT_GT(camera.target->y, 5);
}

TEST(CameraControl, FlyGoesWhereItLooks) {
  CameraOptions camera = front();
  fly(camera, {1, 2, 3});
  expectNear(*camera.eye, {2, 4, 5});
  expectNear(*camera.target, {2, 4, 0});
}

TEST(CameraControl, FitShowsTheWholeSphereOfTheBounds) {
  CameraOptions camera = front();
  camera.size = {100, 200};
  fitView(camera, vec3(-1), vec3(1));
  expectNear(*camera.target, vec3(0));
  const Camera made = makeCamera(camera, vec3(-1), vec3(1));
  const float sine = std::sqrt(3.0f) / glm::length(made.eye);
  EXPECT_NEAR(std::asin(sine), std::atan(made.tanHalfFov * 0.5f), 1e-5f);  // the width is the narrower way
}

TEST(CameraControl, UpMayBeAnyDirection) {
  CameraOptions camera = front();
  camera.up = {0, 0, 2};
  camera.eye = vec3(6, 2, 3);
  orbit(camera, 90, 0);
  expectNear(*camera.eye, {1, 7, 3});
}

TEST(CameraControl, APathMeetsItsCameras) {
  std::vector<CameraOptions> path(4, front());
  for (int i = 0; i < 4; ++i) {
    path[size_t(i)].eye = vec3(i * i, 1, -i);
    path[size_t(i)].fovDegrees = 30 + float(i);
  }
  for (int i = 0; i < 4; ++i) {
    const CameraOptions camera = cameraOnPath(path, float(i) / 3);
    expectNear(*camera.eye, *path[size_t(i)].eye);
    EXPECT_NEAR(camera.fovDegrees, 30 + float(i), 1e-3f);
  }
  EXPECT_NEAR(cameraOnPath(path, 0.5f).eye->z, -1.5f, 1e-4f);  // straight stays straight
}

TEST(CameraControl, ATurntableEndsWhereItBegan) {
  const auto cameras = turntableCameras(front(), 8);
  ASSERT_EQ(cameras.size(), 8u);
  expectNear(*cameras[0].eye, *front().eye);
  expectNear(*cameras[4].eye, {1, 2, -2});
  CameraOptions next = cameras[7];
  orbit(next, 45, 0);
  expectNear(*next.eye, *front().eye);
}

}  // namespace
}  // namespace boxlight::gpu
