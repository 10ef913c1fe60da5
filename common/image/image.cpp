// SPDX-License-Identifier: Apache-2.0
#include "common/image/image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "common/base/error.h"
#include "common/base/file.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

constexpr int kMaxSide = 32768;
constexpr uint64_t kMaxPixels = uint64_t(1) << 28;

[[noreturn]] void failImage(const std::filesystem::path& path, const std::string& reason) {
  fail(ExitCode::invalidInput, "{}: not a usable image: {}", path.string(), reason);
}

std::unique_ptr<OIIO::ImageInput> openImage(const std::filesystem::path& path) {
  errno = 0;
  if (std::filesystem::is_directory(path) || !std::ifstream(path))
    fail(ExitCode::io, "{}: cannot open: {}", path.string(), errno ? std::strerror(errno) : "it is a folder");
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // so that sRGB is decoded before alpha is multiplied in
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) failImage(path, OIIO::geterror());
  return input;
}

void checkSpec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  if (spec.deep || spec.depth > 1) failImage(path, "deep images and volumes are not read");
  if (spec.width < 1 || spec.height < 1 || spec.width > kMaxSide || spec.height > kMaxSide ||
      uint64_t(spec.width) * uint64_t(spec.height) > kMaxPixels)
    failImage(path, fmt::format("{}x{} pixels; the limit is {} a side and {} in all", spec.width, spec.height,
                                kMaxSide, kMaxPixels));
  if (spec.width != spec.full_width || spec.height != spec.full_height || spec.x != spec.full_x ||
      spec.y != spec.full_y)
    failImage(path, "its data window is not its display window; crop or pad it first");
}

constexpr int kNone = -1;

/// Places of red, green, blue and alpha among a file's channels; grey has one colour.
struct ChannelChoice {
  std::vector<int> colours;
  int alpha = kNone;
};

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The channel "LAYER.x" or "LAYER.long" of any case.
int findChannel(const std::vector<std::string>& names, const std::string& layer, const std::string& brief,
                const std::string& full) {
  for (size_t i = 0; i < names.size(); ++i)
    if (const std::string name = lower(names[i]); name == layer + brief || name == layer + full)
      return int(i);
  return kNone;
}

/// The first layer that has red, green and blue, by their names; else as many channels as colours have.
ChannelChoice chooseChannels(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  const auto& names = spec.channelnames;
  for (const std::string& name : names) {
    const std::string layer = lower(name.substr(0, name.rfind('.') + 1));
    const int r = findChannel(names, layer, "r", "red"), g = findChannel(names, layer, "g", "green"),
              b = findChannel(names, layer, "b", "blue");
    if (r != kNone && g != kNone && b != kNone) return {{r, g, b}, findChannel(names, layer, "a", "alpha")};
  }
  if (findChannel(names, "", "ry", "ry") != kNone)
    failImage(path, "luminance and chroma (Y, RY, BY); convert it to R, G and B first");
  if (spec.nchannels > 4)
    failImage(path, fmt::format("{} channels without R, G and B among them", spec.nchannels));
  if (spec.nchannels >= 3) return {{0, 1, 2}, spec.nchannels == 4 ? 3 : kNone};
  return {{0}, spec.nchannels == 2 ? 1 : kNone};
}

/// To linear and premultiplied, from what the file says about itself.
void decodeColours(Image& image, const OIIO::ImageSpec& spec) {
  const std::string space(spec.get_string_attribute("oiio:ColorSpace"));
  const float gamma = spec.get_float_attribute("oiio:Gamma", 1.0f);
  const bool isSrgb = space == "sRGB",
             isGamma = !isSrgb && gamma > 0.0f && gamma != 1.0f && space.starts_with("Gamma");
  const bool isStraight = hasAlpha(image) && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  if (!isSrgb && !isGamma && !isStraight) return;
  const uint32_t colours = hasAlpha(image) ? image.channels - 1 : image.channels;
  for (size_t i = 0; i < image.pixels.size(); i += image.channels) {
    float* p = &image.pixels[i];
    const float alpha = isStraight ? p[colours] : 1.0f;
    for (uint32_t c = 0; c < colours; ++c) {
      if (isSrgb) p[c] = decodeSrgb(p[c]);
      if (isGamma) p[c] = std::pow(std::max(p[c], 0.0f), gamma);
      p[c] *= alpha;
    }
  }
}

/// The channels at `places`, in that order; `first` is the place of the image's first.
Image pickChannels(Image image, std::vector<int> places, int first) {
  bool inPlace = places.size() == image.channels;
  for (size_t i = 0; i < places.size(); ++i) inPlace = inPlace && (places[i] -= first) == int(i);
  if (inPlace) return image;
  Image picked = makeImage(image.width, image.height, uint32_t(places.size()));
  const size_t pixels = size_t(image.width) * image.height;
  for (size_t p = 0; p < pixels; ++p)
    for (size_t c = 0; c < places.size(); ++c)
      picked.pixels[p * places.size() + c] = image.pixels[p * image.channels + size_t(places[c])];
  return picked;
}

OIIO::ImageSpec outputSpec(const std::filesystem::path& path, const Image& image) {
  const bool isPng = path.extension() == ".png";
  OIIO::ImageSpec spec(int(image.width), int(image.height), int(image.channels),
                       isPng ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  if (isPng) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
  } else {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // or OpenImageIO writes the time of day, and equal pictures differ
  }
  return spec;
}

}  // namespace

Image makeImage(uint32_t width, uint32_t height, uint32_t channels) {
  return {width, height, channels, std::vector<float>(size_t(width) * height * channels, 0.0f)};
}

Image readImage(const std::filesystem::path& path) {
  const auto input = openImage(path);
  const OIIO::ImageSpec& spec = input->spec();
  checkSpec(path, spec);
  const ChannelChoice choice = chooseChannels(path, spec);
  std::vector<int> places = choice.colours;
  if (choice.alpha != kNone) places.push_back(choice.alpha);
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  const int first = *low, stored = *high + 1 - first;
  Image image = makeImage(uint32_t(spec.width), uint32_t(spec.height), uint32_t(stored));
  if (!input->read_image(0, 0, first, first + stored, OIIO::TypeDesc::FLOAT, image.pixels.data()))
    failImage(path, input->geterror());
  image = pickChannels(std::move(image), places, first);
  decodeColours(image, spec);
  return image;
}

void checkImageExtension(const std::filesystem::path& path) {
  if (path.extension() != ".exr" && path.extension() != ".png")
    fail(ExitCode::usage, "{}: pictures are written as .exr or .png", path.string());
}

void writeImage(const std::filesystem::path& path, const Image& image) {
  checkImageExtension(path);
  assert(image.pixels.size() == size_t(image.width) * image.height * image.channels);
  AtomicFile file(path);
  const std::string name = file.temporaryPath().string();
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) fail(ExitCode::io, "{}: cannot write: {}", path.string(), OIIO::geterror());
  if (!output->open(name, outputSpec(path, image)) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data()) || !output->close())
    fail(ExitCode::io, "{}: cannot write: {}", path.string(), output->geterror());
  file.commit();
}

Image toDisplay(const Image& linear, float exposureEv, ToneMap toneMap) {
  Image display = linear;
  const float gain = std::exp2(exposureEv);
  const uint32_t colours = hasAlpha(linear) ? linear.channels - 1 : linear.channels;
  for (size_t i = 0; i < display.pixels.size(); i += display.channels) {
    float* p = &display.pixels[i];
    const float alpha = hasAlpha(linear) ? p[colours] : 1.0f;
    const float scale = alpha > 0.0f ? gain / alpha : gain;
    const Rgb radiance = colours >= 3 ? Rgb(p[0], p[1], p[2]) : Rgb(p[0]);
    const Rgb mapped = applyToneMap(toneMap, radiance * scale);
    for (uint32_t c = 0; c < colours; ++c) p[c] = encodeSrgb(mapped[int(c)]);
  }
  return display;
}

float encodeSrgb(float linear) {
  if (!(linear > 0.0f)) return 0.0f;  // NaN too
  if (linear >= 1.0f) return 1.0f;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float decodeSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace boxlight
