// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "bake/scene/material.h"

namespace boxlight {
namespace {

using Table = std::array<float, 256>;

Table linearTable() {
  Table table;
  for (size_t i = 0; i < 256; ++i) table[i] = float(i) / 255.0f;
  return table;
}

// IEC 61966-2-1.
Table srgbTable() {
  Table table;
  for (size_t i = 0; i < 256; ++i) {
    const double c = double(i) / 255.0;
    table[i] = float(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return table;
}

const Table kLinearTable = linearTable(), kSrgbTable = srgbTable();

vec4 decode(uint32_t texel, const Table& rgb) {
  return {rgb[texel & 255], rgb[texel >> 8 & 255], rgb[texel >> 16 & 255], kLinearTable[texel >> 24]};
}

// The coordinate inside the image, [0,1].
float wrapCoordinate(float x, asset::Wrap wrap) {
  if (wrap == asset::Wrap::clampToEdge) return std::clamp(x, 0.0f, 1.0f);
  if (wrap == asset::Wrap::repeat) return x - std::floor(x);
  const float period = x - 2.0f * std::floor(0.5f * x);
  return period <= 1.0f ? period : 2.0f - period;
}

// One texel beyond an edge: the far side if the image repeats, else the same texel again.
uint32_t wrapTexel(int i, uint32_t size, asset::Wrap wrap) {
  const bool repeat = wrap == asset::Wrap::repeat;
  if (i < 0) return repeat ? size - 1 : 0;
  if (i >= int(size)) return repeat ? 0 : size - 1;
  return uint32_t(i);
}

// The two texels between which a coordinate lies, and how near it is to the second.
struct Span {
  uint32_t first, second;
  float weight;
};
Span spanOf(float coordinate, uint32_t size, asset::Wrap wrap) {
  const float x = wrapCoordinate(coordinate, wrap) * float(size) - 0.5f;
  const float cell = std::floor(x);
  return {wrapTexel(int(cell), size, wrap), wrapTexel(int(cell) + 1, size, wrap), x - cell};
}

}  // namespace

vec4 sampleTexture(const Scene& scene, uint32_t texture, vec2 uv) {
  const asset::Texture& t = scene.textures[texture];
  const uint32_t* texels = scene.texels.data() + t.firstTexel;
  const Table& rgb = t.srgb ? kSrgbTable : kLinearTable;
  const auto at = [&](uint32_t x, uint32_t y) { return decode(texels[size_t(y) * t.width + x], rgb); };
  if (t.magNearest) {
    const auto nearest = [](float coordinate, uint32_t size, asset::Wrap wrap) {
      return std::min(uint32_t(wrapCoordinate(coordinate, wrap) * float(size)), size - 1);
    };
    return at(nearest(uv.x, t.width, t.wrapS), nearest(uv.y, t.height, t.wrapT));
  }
  const Span x = spanOf(uv.x, t.width, t.wrapS), y = spanOf(uv.y, t.height, t.wrapT);
  const vec4 upper = glm::mix(at(x.first, y.first), at(x.second, y.first), x.weight);
  const vec4 lower = glm::mix(at(x.first, y.second), at(x.second, y.second), x.weight);
  return glm::mix(upper, lower, y.weight);
}

}  // namespace boxlight
