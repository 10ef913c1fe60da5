// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/session.h"

namespace boxlight::gpu {

bool Session::truthFits() const {
  if (!truth) return false;
  CameraOptions camera = truth->camera;
  camera.size = file.settings.camera.size;
  // Another size of the same shape shows the same part of the scene.
  const vec2 size(camera.size), made(truth->camera.size);
  return camera == file.settings.camera &&
         std::abs(size.x * made.y - size.y * made.x) <= std::max(size.x, size.y) &&
         truth->environment == file.environment.string() &&
         truth->environmentDegrees == file.settings.environmentDegrees &&
         truth->environmentTilt == file.settings.environmentTilt &&
         truth->environmentIntensity == file.settings.environmentIntensity;
}

}  // namespace boxlight::gpu
