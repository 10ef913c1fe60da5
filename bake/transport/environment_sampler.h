// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/image/image.h"
#include "common/light/environment.h"

namespace boxlight {

/// The environment as a light source: radiance by direction, and directions drawn in proportion to it.
/// A texel is chosen by the luminance that bilinear interpolation leaves inside it, then a direction
/// uniformly in its solid angle, so no direction with light has density zero and a sun of one texel is found.
class EnvironmentSampler {
 public:
  /// `rotationDegrees` turns the environment about +Y (light_domain.h). The image must outlive the sampler.
  EnvironmentSampler(const Image& environment, float rotationDegrees);

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
  float offset_;                        ///< of u, in turns
  std::vector<double> rows_, columns_;  ///< cumulative: rows_[y], columns_[y * width + x]
};

}  // namespace boxlight
