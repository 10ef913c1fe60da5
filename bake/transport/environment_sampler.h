// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"
#include "common/light/environment.h"
#include "common/light/environment_tilt.h"

namespace boxlight {

/// The environment as a light source: radiance by direction, and directions drawn in proportion to it.
/// A texel is chosen by the luminance that bilinear interpolation leaves inside it, then a direction
/// uniformly in its solid angle, so no direction with light has density zero and a sun of one texel is found.
class EnvironmentSampler {
 public:
  /// `rotationDegrees` and `tilt` turn the environment (environment_tilt.h). The image must outlive the
  /// sampler.
  EnvironmentSampler(const Image& environment, float rotationDegrees, EnvironmentTilt tilt = {});

  struct Sample {
    vec3 direction;
    Rgb radiance;
    float density;  ///< per steradian; 0 if the environment is black
  };
  Sample sample(vec2 random) const;
  Rgb radiance(vec3 direction) const;
  float density(vec3 direction) const;

 private:
  vec2 imageUv(vec3 direction) const;
  double texelSolidAngle(uint32_t row) const;

  const Image& image_;
  float offset_;                        ///< of u, in turns; 0 with a tilt
  bool level_;                          ///< no tilt: the offset alone turns, and toImage_ is not used
  glm::mat3 toImage_;                   ///< directions of the world to directions of the image
  std::vector<double> rows_, columns_;  ///< cumulative: rows_[y], columns_[y * width + x]
};

}  // namespace boxlight
