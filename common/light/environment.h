// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/image/image.h"

namespace boxlight {

/// A distant light: an RGB equirectangular image (light_domain.h) of radiance, any size from 1x1. Grey
/// becomes RGB, alpha is dropped. Texel values that are no light are replaced and counted in a warning: NaN
/// and negative by 0, Inf by the largest finite value of its channel. Errors: those of readImage;
/// ExitCode::invalidInput if no texel is finite.
Image readEnvironment(const std::filesystem::path& path);

/// What readEnvironment does after reading. `name` is for messages.
Image toEnvironment(const Image& image, const std::string& name);

/// Radiance from `uv`, bilinear: periodic in u, clamped in v, pixel centres at +.5.
Rgb sampleEnvironment(const Image& environment, vec2 uv);

}  // namespace boxlight
