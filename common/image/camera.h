// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "common/base/math.h"

namespace boxlight {

/// The camera as the user gives it; see makeCamera for what is left out.
struct CameraOptions {
  std::optional<vec3> eye, target;  ///< metres
  vec3 up{0.0f, 1.0f, 0.0f};
  float fovDegrees = 40.0f;  ///< vertical
  uvec2 size{512, 512};      ///< pixels

  bool operator==(const CameraOptions&) const = default;
};

/// --eye --target --up --fov --size.
void addCameraOptions(CLI::App& command, CameraOptions& options);

/// A pinhole camera with square pixels, (0,0) at the top left.
struct Camera {
  vec3 eye{0.0f};
  vec3 forward{0.0f, 0.0f, -1.0f}, right{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};  ///< orthonormal
  float tanHalfFov = 1.0f;  ///< of the vertical field of view
  uvec2 size{1, 1};

  /// Unit direction of the ray through a continuous pixel position: (0,0) is the picture's top-left corner,
  /// (size) its bottom-right corner, so pixel (i,j) is the square [i,i+1) x [j,j+1).
  vec3 direction(vec2 pixel) const;

  bool operator==(const Camera&) const = default;
};

/// Completes the options for an object with these bounds. Without a target the camera looks at the centre of
/// the bounds; without an eye it looks from the front, a little right and above, at the distance where the
/// bounding sphere fits the narrower field of view. An `up` along the view direction is replaced by -Z
/// (looking down or up) or +Y. Errors: ExitCode::usage if eye and target coincide or `up` is zero.
Camera makeCamera(const CameraOptions& options, vec3 boundsMin, vec3 boundsMax);

/// From the centre of these bounds, where their sphere fits the narrower field of view of the picture.
float framingDistance(vec3 boundsMin, vec3 boundsMax, const CameraOptions& options);

}  // namespace boxlight
