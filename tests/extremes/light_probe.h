// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "runtime/light/light.h"
#include "tests/extremes/exact_sums.h"

namespace boxlight::test {

struct Integral {
  vec3 light;
  float solidAngle;
};

/// A light on the device, asked by a stranger's shader (probe.comp).
class LightProbe {
 public:
  LightProbe(gpu::Device& device, const Image& environment, const gpu::LightSettings& settings,
             EnvironmentTilt tilt = {});

  std::vector<Integral> integrate(std::span<const GridBox> boxes, float uOffset = 0.0f);
  /// u, du, v, dv and 1 - v - dv, as a shader may have them.
  std::vector<Integral> integrate(const std::vector<std::array<float, 5>>& rectangles, float uOffset = 0.0f);
  float unit() const { return light_.unit(); }

 private:
  gpu::Device& device_;
  gpu::Light light_;
  gpu::Bindings bindings_;
  gpu::ComputePipeline pipeline_;
};

}  // namespace boxlight::test
