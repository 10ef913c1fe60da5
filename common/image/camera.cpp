// SPDX-License-Identifier: Apache-2.0
#include "common/image/camera.h"

#include <cmath>

#include "common/base/cli.h"
#include "common/base/error.h"

namespace boxlight {
namespace {

/// From the object towards the camera when the user names no eye: the front is +Z in glTF.
const vec3 kDefaultSide = glm::normalize(vec3(0.5f, 0.4f, 1.0f));

float tanHalfFov(const CameraOptions& options) {
  return float(std::tan(double(options.fovDegrees) * kPiDouble / 360.0));
}

vec3 usableUp(vec3 up, vec3 forward) {
  if (!(glm::length(up) > 0.0f)) fail(ExitCode::usage, "--up must not be zero");
  up = glm::normalize(up);
  if (glm::length(glm::cross(forward, up)) > 1e-4f) return up;
  return std::abs(forward.y) > 0.5f ? vec3(0, 0, -1) : vec3(0, 1, 0);
}

}  // namespace

float framingDistance(vec3 boundsMin, vec3 boundsMax, const CameraOptions& options) {
  const float radius = 0.5f * glm::length(boundsMax - boundsMin);
  const float aspect = float(options.size.x) / float(options.size.y);
  const float narrower = std::atan(tanHalfFov(options) * std::min(aspect, 1.0f));
  return (radius > 0.0f ? radius : 1.0f) / std::sin(narrower);
}

void addCameraOptions(CLI::App& command, CameraOptions& options) {
  addVec3(command, "--eye", options.eye, "Camera position in metres (default: frames the object)");
  addVec3(command, "--target", options.target, "Point the camera looks at (default: the object's centre)");
  addVec3(command, "--up", options.up, "Up direction (default: 0,1,0)");
  command.add_option("--fov", options.fovDegrees, "Vertical field of view in degrees")
      ->check(inRange(0.1, 170.0))
      ->capture_default_str();
  addSize(command, "--size", options.size, "Size of the picture in pixels (default: 512x512)");
}

vec3 Camera::direction(vec2 pixel) const {
  const vec2 extent(size);
  const vec2 ndc = (2.0f * pixel - extent) / extent.y;  // square pixels: both in units of half the height
  return glm::normalize(forward + tanHalfFov * (ndc.x * right - ndc.y * up));
}

Camera makeCamera(const CameraOptions& options, vec3 boundsMin, vec3 boundsMax) {
  Camera camera;
  camera.size = options.size;
  camera.tanHalfFov = tanHalfFov(options);
  const vec3 target = options.target.value_or(0.5f * (boundsMin + boundsMax));
  camera.eye = options.eye.value_or(target + framingDistance(boundsMin, boundsMax, options) * kDefaultSide);
  const dvec3 offset = dvec3(target) - dvec3(camera.eye);  // double: squares of any float stay finite
  if (!(glm::length(offset) > 0.0)) fail(ExitCode::usage, "--eye and --target must differ");
  camera.forward = vec3(glm::normalize(offset));
  camera.right = glm::normalize(glm::cross(camera.forward, usableUp(options.up, camera.forward)));
  camera.up = glm::cross(camera.right, camera.forward);
  return camera;
}

}  // namespace boxlight
