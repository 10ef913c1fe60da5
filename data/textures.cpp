// SPDX-License-Identifier: Apache-2.0
#include "data/textures.h"

#include <cmath>

namespace boxlight::data {
namespace {

/// `texel(x, y)` gives RGBA in 0..1 at the centre of a texel, x and y in (0,1) from the top left.
template <class Texel>
Texture paint(uint32_t size, Texel texel) {
  Texture texture{size, size, {}, false};
  for (uint32_t j = 0; j < size; ++j)
    for (uint32_t i = 0; i < size; ++i) {
      const vec4 colour = texel((float(i) + 0.5f) / float(size), (float(j) + 0.5f) / float(size));
      for (int k = 0; k < 4; ++k)
        texture.rgba.push_back(uint8_t(std::lround(255.0f * glm::clamp(colour[k], 0.0f, 1.0f))));
    }
  return texture;
}

}  // namespace

Texture checkerTexture(uint32_t size, uint32_t square) {
  const float squares = float(size) / float(square);
  Texture texture = paint(size, [&](float x, float y) {
    const bool odd = (int(x * squares) + int(y * squares)) % 2 != 0;
    const vec3 colour = odd ? vec3(0.8f, 0.35f, 0.25f) : vec3(0.75f, 0.85f, 0.95f);
    return vec4(colour * (0.55f + 0.45f * (1 - x) * y), 1);
  });
  texture.nearest = true;
  return texture;
}

Texture roughnessTexture(uint32_t size) {
  return paint(size, [](float x, float) { return vec4(0, 0.1f + 0.8f * x, 1, 1); });
}

Texture leafTexture(uint32_t size) {
  return paint(size, [](float x, float y) {
    const float across = std::abs(x - 0.5f), along = y;
    const bool inside = across < 0.45f * std::sin(kPi * along) && along > 0.02f && along < 0.98f;
    const vec2 cell = glm::fract(vec2(x, y) * 4.0f) - 0.5f;
    const bool hole = glm::length(cell) < 0.22f && across > 0.08f;
    const float vein = std::min(across, std::abs(glm::fract((along + across) * 6.0f) - 0.5f) * 0.1f);
    const float shade = vein < 0.012f ? 0.6f : 1.0f;
    return vec4(vec3(shade), inside && !hole ? 1 : 0);
  });
}

Texture bumpTexture(uint32_t size, uvec2 count) {
  return paint(size, [&](float x, float y) {
    const vec2 fromCentre = 2.0f * glm::fract(vec2(x, y) * vec2(count)) - 1.0f;
    const float r = glm::length(fromCentre);
    // Height cos^2(pi r / 2): level at the rim and at the top. glTF's y
    // is up in the image.
    const vec2 uphill = r > 0 && r < 1 ? -std::sin(kPi * r) * fromCentre / r : vec2(0.0f);
    const vec3 normal = glm::normalize(vec3(-uphill.x, uphill.y, 1));
    return vec4(0.5f + 0.5f * normal, 1);
  });
}

}  // namespace boxlight::data
