// SPDX-License-Identifier: Apache-2.0
#include "common/light/environment.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "common/base/log.h"
#include "common/light/light_map.h"

namespace boxlight {
namespace {

struct Repairs {
  uint64_t nan = 0, infinite = 0, negative = 0;
};

Image toRgb(Image image) {
  if (image.channels == 3) return image;
  Image rgb = makeImage(image.width, image.height, 3);
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const Rgb value = rgbAt(image, x, y);
      for (int c = 0; c < 3; ++c) rgb.at(x, y)[c] = value[c];
    }
  return rgb;
}

bool isUsable(float value) { return value <= kMostRadiance; }  // not NaN

/// Largest usable value of each channel; negative if there is none.
Rgb largestUsable(const Image& rgb) {
  Rgb largest(-std::numeric_limits<float>::infinity());
  for (size_t i = 0; i < rgb.pixels.size(); ++i)
    if (std::isfinite(rgb.pixels[i]) && isUsable(rgb.pixels[i]))
      largest[int(i % 3)] = std::max(largest[int(i % 3)], rgb.pixels[i]);
  return largest;
}

Repairs repair(Image& rgb, Rgb largest) {
  Repairs repairs;
  for (size_t i = 0; i < rgb.pixels.size(); ++i) {
    float& value = rgb.pixels[i];
    if (value >= kLeastRadiance && value <= kMostRadiance) continue;
    if (isUsable(value)) {
      repairs.negative += value < 0.0f;
      value = 0.0f;
    } else if (std::isnan(value)) {
      ++repairs.nan;
      value = 0.0f;
    } else {
      ++repairs.infinite;
      value = std::max(largest[int(i % 3)], 0.0f);
    }
  }
  return repairs;
}

/// Halves the sides until the image is small enough.
Image shrink(Image rgb, const std::string& name) {
  uvec2 size(rgb.width, rgb.height);
  while (uint64_t(size.x) * size.y > kMostEnvironmentPixels) size = glm::max(size / 2u, 1u);
  if (size == uvec2(rgb.width, rgb.height)) return rgb;
  log().warn("{}: {}x{} pixels are averaged to {}x{}; the energy is kept", name, rgb.width, rgb.height,
             size.x, size.y);
  return makeLightMap(rgb, size);
}

}  // namespace

Image toEnvironment(Image image, const std::string& name) {
  Image rgb = toRgb(std::move(image));
  const Rgb largest = largestUsable(rgb);
  if (!std::isfinite(maxComponent(largest)))
    fail(ExitCode::invalidInput, "{}: not a usable environment: no texel has a finite value", name);
  const Repairs repairs = repair(rgb, largest);
  if (repairs.nan + repairs.negative + repairs.infinite > 0)
    log().warn(
        "{}: values that are no radiance: {} NaN and {} negative set to 0, {} infinite or above {:.3g} set "
        "to "
        "the largest other value",
        name, repairs.nan, repairs.negative, repairs.infinite, double(kMostRadiance));
  return shrink(std::move(rgb), name);
}

Image readEnvironment(const std::filesystem::path& path) {
  return toEnvironment(readImage(path), path.string());
}

Rgb sampleEnvironment(const Image& environment, vec2 uv) {
  assert(environment.channels == 3);
  const int width = int(environment.width), height = int(environment.height);
  const float x = (uv.x - std::floor(uv.x)) * float(width) - 0.5f;
  const float y = std::clamp(uv.y * float(height) - 0.5f, 0.0f, float(height - 1));
  const int x0 = int(std::floor(x)), y0 = int(y);
  const float fx = x - float(x0), fy = y - float(y0);
  auto texel = [&](int column, int row) {
    return rgbAt(environment, uint32_t((column + width) % width), uint32_t(std::min(row, height - 1)));
  };
  return glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), fx),
                  glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fx), fy);
}

}  // namespace boxlight
