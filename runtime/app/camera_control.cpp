// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/camera_control.h"

#include <cmath>

namespace boxlight::gpu {
namespace {

constexpr float kPole = 89.0f;  // degrees above the horizon at most
constexpr float kNearest = 1e-5f, kFarthest = 1e9f;

float radians(float degrees) { return degrees * kPi / 180.0f; }

/// Right, up and forward of a camera that stands upright.
struct Frame {
  explicit Frame(const CameraOptions& camera) : axis(glm::normalize(camera.up)) {
    forward = glm::normalize(*camera.target - *camera.eye);
    const vec3 side = glm::cross(forward, axis);
    vec3 other, ignored;
    orthonormalBasis(axis, other, ignored);
    right = glm::length(side) > 1e-4f ? glm::normalize(side) : other;
    up = glm::cross(right, forward);
  }
  vec3 axis, right, up, forward;
};

/// A unit direction turned about the up axis, then raised, but never past a pole.
vec3 turned(const CameraOptions& camera, vec3 direction, float about, float above) {
  const vec3 axis = glm::normalize(camera.up);
  const Frame frame(camera);
  const float height = std::clamp(glm::dot(direction, axis), -1.0f, 1.0f);
  vec3 level = direction - height * axis;
  // Over a pole the direction has no level part; the picture's own up has.
  level = glm::length(level) > 1e-4f ? glm::normalize(level) : glm::normalize(glm::cross(axis, frame.right));
  const float raised = std::clamp(std::asin(height) + radians(above), -radians(kPole), radians(kPole));
  const float angle = radians(about);
  const vec3 rotated = std::cos(angle) * level + std::sin(angle) * glm::cross(axis, level);
  return std::cos(raised) * rotated + std::sin(raised) * axis;
}

template <class T>
T catmullRom(const T& a, const T& b, const T& c, const T& d, float t) {
  return b + 0.5f * t * ((c - a) + t * ((2.0f * a - 5.0f * b + 4.0f * c - d) + t * (3.0f * (b - c) + d - a)));
}

}  // namespace

CameraOptions completeCamera(const CameraOptions& options, vec3 boundsMin, vec3 boundsMax) {
  CameraOptions complete = options;
  complete.target = options.target.value_or(0.5f * (boundsMin + boundsMax));
  complete.eye = makeCamera(options, boundsMin, boundsMax).eye;
  return complete;
}

void orbit(CameraOptions& camera, float right, float above) {
  const vec3 offset = *camera.eye - *camera.target;
  const float distance = glm::length(offset);
  camera.eye = *camera.target + distance * turned(camera, offset / distance, right, above);
}

void pan(CameraOptions& camera, vec2 heights) {
  const Frame frame(camera);
  const float height =
      2.0f * std::tan(radians(camera.fovDegrees) / 2) * glm::length(*camera.target - *camera.eye);
  const vec3 step = height * (heights.x * frame.right + heights.y * frame.up);
  *camera.eye += step;
  *camera.target += step;
}

void zoom(CameraOptions& camera, float factor) {
  const vec3 offset = *camera.eye - *camera.target;
  const float distance = glm::length(offset);
  camera.eye = *camera.target + offset * (std::clamp(distance / factor, kNearest, kFarthest) / distance);
}

void look(CameraOptions& camera, float right, float above) {
  const vec3 offset = *camera.target - *camera.eye;
  const float distance = glm::length(offset);
  camera.target = *camera.eye + distance * turned(camera, offset / distance, -right, above);
}

void fly(CameraOptions& camera, vec3 rightUpForward) {
  const Frame frame(camera);
  const vec3 step =
      rightUpForward.x * frame.right + rightUpForward.y * frame.axis + rightUpForward.z * frame.forward;
  *camera.eye += step;
  *camera.target += step;
}

void fitView(CameraOptions& camera, vec3 boundsMin, vec3 boundsMax) {
  const vec3 forward = Frame(camera).forward;
  camera.target = 0.5f * (boundsMin + boundsMax);
  camera.eye = *camera.target - framingDistance(boundsMin, boundsMax, camera) * forward;
}

CameraOptions cameraOnPath(const std::vector<CameraOptions>& path, float t) {
  const auto last = int(path.size()) - 1;
  const float position = std::clamp(t, 0.0f, 1.0f) * float(last);
  const int knot = std::min(int(position), last - 1);
  const auto at = [&](int i) -> const CameraOptions& { return path[size_t(std::clamp(i, 0, last))]; };
  const auto blend = [&](auto&& of) {
    return catmullRom(of(at(knot - 1)), of(at(knot)), of(at(knot + 1)), of(at(knot + 2)),
                      position - float(knot));
  };
  CameraOptions camera = at(knot);
  camera.eye = blend([](const CameraOptions& c) { return *c.eye; });
  camera.target = blend([](const CameraOptions& c) { return *c.target; });
  camera.fovDegrees = blend([](const CameraOptions& c) { return c.fovDegrees; });
  return camera;
}

}  // namespace boxlight::gpu
