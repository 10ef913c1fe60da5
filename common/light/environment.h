// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/image/image.h"

namespace boxlight {

/// Radiance of an environment is 0 or within these: products with the shares of texels (light_map.h) then
/// stay normal floats and sums of them finite, and devices that flush subnormal numbers give the same bits.
inline constexpr float kLeastRadiance = 0x1p-80f, kMostRadiance = 0x1p100f;
/// Larger images are area-resampled to this many pixels at most, with their energy.
inline constexpr uint64_t kMostEnvironmentPixels = uint64_t(8192) * 4096;

/// A distant light: an RGB equirectangular image (light_domain.h) of radiance, any size from 1x1 to what
/// readImage takes. Grey becomes RGB, alpha is dropped. Texel values that are no light are replaced and
/// counted in a warning: NaN and negative by 0, Inf and what is above kMostRadiance by the largest value of
/// its channel that is neither. Less than kLeastRadiance is 0. Errors: those of readImage;
/// ExitCode::invalidInput if no texel is finite.
Image readEnvironment(const std::filesystem::path& path);

/// What readEnvironment does after reading. `name` is for messages.
Image toEnvironment(Image image, const std::string& name);

/// Radiance from `uv`, bilinear: periodic in u, clamped in v, pixel centres at +.5.
Rgb sampleEnvironment(const Image& environment, vec2 uv);

}  // namespace boxlight
