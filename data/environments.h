// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "common/image/image.h"

namespace boxlight::data {

struct EnvironmentRecipe {
  std::string name, about;
  Image (*make)();
};

/// Equirectangular radiance images with the conventions of common/light/light_domain.h.
const std::vector<EnvironmentRecipe>& environmentRecipes();

/// Error: ExitCode::usage for an unknown name.
Image makeEnvironment(const std::string& name);

/// What the tests compare with.
struct Sun {
  vec3 direction;       ///< unit
  float angularRadius;  ///< radians
  Rgb radiance;
};
Sun skySun();
inline constexpr uvec2 kLitTexel{200, 40};  ///< the one texel of "texel_sun", an image of kTexelSunSize
inline constexpr uvec2 kTexelSunSize{256, 128};

}  // namespace boxlight::data
