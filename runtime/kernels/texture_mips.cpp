// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/texture_mips.h"

#include <array>
#include <cmath>

#include "common/image/image.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kTrilinear = 2;  // asset::Texture::minFilter

std::array<float, 256> decodeTable(bool srgb) {
  std::array<float, 256> table;
  for (uint32_t code = 0; code < 256; ++code) {
    const float value = float(code) / 255.0f;
    table[code] = srgb ? decodeSrgb(value) : value;
  }
  return table;
}

/// Up to three source texels under one of half as many, and their shares of its width.
struct Taps {
  uint32_t first = 0, count = 0;
  std::array<float, 3> share{};
};

Taps tapsOf(uint32_t target, uint32_t targetSize, uint32_t sourceSize) {
  const double width = double(sourceSize) / targetSize, start = target * width, end = start + width;
  Taps taps;
  taps.first = uint32_t(start);
  while (taps.count < 3 && taps.first + taps.count < sourceSize) {
    const double left = std::max<double>(start, taps.first + taps.count);
    const double right = std::min<double>(end, taps.first + taps.count + 1);
    if (right <= left) break;
    taps.share[taps.count++] = float((right - left) / width);
  }
  return taps;
}

class MipChain {
 public:
  MipChain(TextureSet& set, bool srgb)
      : set_(set), srgb_(srgb), color_(decodeTable(srgb)), alpha_(decodeTable(false)) {}

  void append(const TextureLevel& source) {
    TextureLevel level{uint32_t(set_.texels.size()), std::max(source.width / 2, 1u),
                       std::max(source.height / 2, 1u), 0};
    for (uint32_t y = 0; y < level.height; ++y)
      for (uint32_t x = 0; x < level.width; ++x)
        set_.texels.push_back(
            mean(source, tapsOf(x, level.width, source.width), tapsOf(y, level.height, source.height)));
    set_.levels.push_back(level);
  }

 private:
  uint32_t mean(const TextureLevel& source, const Taps& columns, const Taps& rows) const {
    vec4 sum(0.0f);
    for (uint32_t j = 0; j < rows.count; ++j)
      for (uint32_t i = 0; i < columns.count; ++i) {
        const uint32_t word =
            set_.texels[source.firstTexel + (rows.first + j) * source.width + columns.first + i];
        const vec4 texel(color_[word & 255], color_[word >> 8 & 255], color_[word >> 16 & 255],
                         alpha_[word >> 24]);
        sum += rows.share[j] * columns.share[i] * texel;
      }
    uint32_t word = 0;
    for (int c = 0; c < 4; ++c) {
      const float encoded = srgb_ && c < 3 ? encodeSrgb(sum[c]) : sum[c];
      word |= uint32_t(std::lround(std::clamp(encoded, 0.0f, 1.0f) * 255.0f)) << 8 * c;
    }
    return word;
  }

  TextureSet& set_;
  bool srgb_;
  std::array<float, 256> color_, alpha_;
};

}  // namespace

TextureSet makeTextureSet(const asset::Asset& asset) {
  TextureSet set;
  set.texels = asset.texels;
  for (const asset::Texture& texture : asset.textures) {
    const auto firstLevel = uint32_t(set.levels.size());
    set.levels.push_back({texture.firstTexel, texture.width, texture.height, 0});
    MipChain chain(set, texture.srgb != 0);
    while (texture.minFilter == kTrilinear && (set.levels.back().width > 1 || set.levels.back().height > 1))
      chain.append(TextureLevel(set.levels.back()));
    set.headers.push_back({firstLevel, uint32_t(set.levels.size()) - firstLevel, uint32_t(texture.wrapS),
                           uint32_t(texture.wrapT), texture.srgb, texture.magNearest, texture.minFilter, 0});
  }
  return set;
}

}  // namespace boxlight::gpu
