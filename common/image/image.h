// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "common/base/math.h"
#include "common/image/tone_map.h"

namespace boxlight {

/// Interleaved float32 pixels, row 0 at the top. Colours are linear Rec.709 radiance unless a function says
/// otherwise. With four channels the last is alpha and the colours are premultiplied by it.
struct Image {
  uint32_t width = 0, height = 0, channels = 0;
  std::vector<float> pixels;  ///< width * height * channels

  float* at(uint32_t x, uint32_t y) { return pixels.data() + offset(x, y); }
  const float* at(uint32_t x, uint32_t y) const { return pixels.data() + offset(x, y); }

 private:
  size_t offset(uint32_t x, uint32_t y) const {
    assert(x < width && y < height);
    return (size_t(y) * width + x) * channels;
  }
};

/// All zero.
Image makeImage(uint32_t width, uint32_t height, uint32_t channels);

/// The colour of a pixel of an image of any number of channels: one or two are grey.
inline Rgb rgbAt(const Image& image, uint32_t x, uint32_t y) {
  const float* p = image.at(x, y);
  return image.channels >= 3 ? Rgb(p[0], p[1], p[2]) : Rgb(p[0]);
}

/// Has the image an alpha channel?
inline bool hasAlpha(const Image& image) { return image.channels == 2 || image.channels == 4; }
inline float alphaAt(const Image& image, uint32_t x, uint32_t y) {
  return hasAlpha(image) ? image.at(x, y)[image.channels - 1] : 1.0f;
}

/// Anything that OpenImageIO reads, at most 32768 pixels a side and 2^28 in all. Files that
/// say they are sRGB (PNG, JPEG...) are decoded to linear; straight alpha is multiplied in. Channels go by
/// their names, of any case and order: R or red, G or green, B or blue, A or alpha, "LAYER.R" of the first
/// layer that has all three; channels without such names are taken as they come, if there are 1 to 4. Values
/// are not checked: NaN and Inf come through. Errors: ExitCode::io if the file cannot be opened,
/// ExitCode::invalidInput with OpenImageIO's reason if it is damaged.
Image readImage(const std::filesystem::path& path);

/// `.exr`: the values as they are, 1, 3 or 4 channels, float32, zip. `.png`: 8 bits of an image from
/// toDisplay. The same pixels give the same bytes. Written by AtomicFile. Errors: ExitCode::usage for another
/// extension, ExitCode::io.
void writeImage(const std::filesystem::path& path, const Image& image);
/// Throws the usage error of writeImage at once, before hours are spent on the picture.
void checkImageExtension(const std::filesystem::path& path);

/// What every PNG that the programs write holds: radiance times 2^exposureEv, tone-mapped (tone_map.h;
/// without a curve it is clamped to [0,1]), sRGB-encoded. Alpha is kept, and the colours of the result are
/// straight, as PNG stores them. NaN becomes 0.
Image toDisplay(const Image& linear, float exposureEv = 0.0f, ToneMap toneMap = ToneMap::none);

/// The sRGB curve of IEC 61966-2-1 for [0,1] and its inverse.
float encodeSrgb(float linear);
float decodeSrgb(float encoded);

}  // namespace boxlight
