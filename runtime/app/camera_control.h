// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/camera.h"

namespace boxlight::gpu {

/// What hands do to a camera. Every function needs `eye` and `target` set (completeCamera) and leaves them
/// set, and apart. Angles are degrees.

/// Fills in what makeCamera would assume for these bounds.
CameraOptions completeCamera(const CameraOptions& options, vec3 boundsMin, vec3 boundsMax);

/// Around the target: `right` turns the camera about `up` towards its right, `above` raises it; it stays one
/// degree off the poles.
void orbit(CameraOptions& camera, float right, float above);

/// Moves eye and target in the picture's plane, by parts of the picture's height at the target's distance.
void pan(CameraOptions& camera, vec2 heights);

/// Divides the distance to the target by `factor`.
void zoom(CameraOptions& camera, float factor);

/// Turns the view about the eye, as orbit() does about the target.
void look(CameraOptions& camera, float right, float above);

/// Moves eye and target by metres along the camera's own right, the up direction, and forward.
void fly(CameraOptions& camera, vec3 rightUpForward);

/// Looks at the whole object from where the camera is.
void fitView(CameraOptions& camera, vec3 boundsMin, vec3 boundsMax);

/// Camera `t` of a path, 0 to 1 over all of it: eye, target and field of view by Catmull-Rom splines of
/// uniform knots through at least two cameras.
CameraOptions cameraOnPath(const std::vector<CameraOptions>& path, float t);

}  // namespace boxlight::gpu
