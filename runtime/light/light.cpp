// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light.h"

#include "common/base/log.h"
#include "common/light/light_map.h"

namespace boxlight::gpu {
namespace {

// The samples of a tilted map keep the energy below the ceiling only nearly.
constexpr double kTiltMargin = 1.5;

/// Halves an environment until a storage buffer holds it.
Image fit(const Image& environment, const Device& device) {
  uvec2 size(environment.width, environment.height);
  while (uint64_t(size.x) * size.y * 3 * sizeof(float) > device.limits().maxStorageBufferRange)
    size = glm::max(size / 2u, 1u);
  if (size == uvec2(environment.width, environment.height)) return environment;
  log().warn("the environment is averaged to {}x{} pixels, which is what '{}' holds; the energy is kept",
             size.x, size.y, device.info().name);
  return makeLightMap(environment, size);
}

}  // namespace

Light::Light(Device& device, const Image& environment, EnvironmentTilt tilt, const LightSettings& settings)
    : device_(device),
      settings_(settings),
      image_(fit(environment, device)),
      tilt_(tilt),
      bindings_(device),
      map_(device, bindings_, settings.size),
      table_(device, bindings_, settings.size, settings.scheme, settings.build) {
  if (settings.moments) moments_.emplace(device, bindings_, settings.size, settings.lightTrees);
  map_.setImage(device, bindings_, image_);
  prepare();
}

void Light::setEnvironment(const Image& environment) {
  image_ = fit(environment, device_);
  map_.setImage(device_, bindings_, image_);
  prepare();
}

void Light::setTilt(EnvironmentTilt tilt) {
  if (tilt == tilt_) return;
  tilt_ = tilt;
  prepare();
}

void Light::prepare() {
  map_.setTilt(device_, bindings_, image_, tilt_);
  const double total = strongestTotal(image_), margin = tilt_.isLevel() ? 1.0 : kTiltMargin;
  const FixedPoint fixedPoint = chooseFixedPoint(total * margin, settings_.size, settings_.scheme);
  nextUnit_ = fixedPoint.unit;
  table_.setFixedPoint(device_, bindings_, fixedPoint);
  if (moments_) moments_->setTotal(device_, bindings_, total, margin);
  needsBuild_ = true;
}

void Light::build(Commands& commands) const {
  map_.make(commands);
  table_.build(commands);
  if (moments_) moments_->build(commands);
}

void Light::show() {
  table_.flip();
  if (moments_) moments_->flip();
  unit_ = nextUnit_;
  needsBuild_ = false;
}

}  // namespace boxlight::gpu
