// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_texture.h"

#include <cstring>
#include <limits>

#include "bake/scene/gltf_error.h"
#include "bake/scene/gltf_support.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

asset::Wrap wrapOf(int code) {
  switch (code) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return asset::Wrap::clampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return asset::Wrap::mirroredRepeat;
    default:
      return asset::Wrap::repeat;
  }
}

// As asset::Texture counts them; a sampler that leaves it open (-1) filters as well as it can.
uint32_t minFilterOf(int code) {
  switch (code) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
      return 0;
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
      return 1;
    default:
      return 2;
  }
}

// To 8 bits per channel, rounded.
void reduceTo8Bits(tinygltf::Image& image) {
  std::vector<unsigned char> reduced(image.image.size() / 2);
  for (size_t i = 0; i < reduced.size(); ++i) {
    uint16_t value;
    std::memcpy(&value, image.image.data() + 2 * i, sizeof value);
    reduced[i] = static_cast<unsigned char>((uint32_t(value) * 255 + 32767) / 65535);
  }
  image.image = std::move(reduced);
}

// RGBA8 of an image that holds its encoded bytes.
tinygltf::Image decodeImage(const GltfDocument& file, const std::string& place, int index) {
  const std::vector<unsigned char>& bytes = file.model.images[size_t(index)].image;
  tinygltf::Image decoded;
  std::string error, warning;
  if (!tinygltf::LoadImageData(&decoded, index, &error, &warning, 0, 0, bytes.data(), int(bytes.size()),
                               nullptr)) {
    failAt(ExitCode::invalidInput, file.path, place, "cannot be decoded; save it as PNG or JPEG");
  }
  if (decoded.bits == 16) {
    log().warn("{}: {}: 16 bits per channel are rounded to 8", file.path.string(), place);
    reduceTo8Bits(decoded);
  }
  return decoded;
}

// The extension that a texture without a source gets its image by; empty if there is none.
std::string onlyExtension(const nlohmann::json& texture) {
  const auto extensions = texture.find("extensions");
  if (extensions == texture.end() || !extensions->is_object() || extensions->empty()) return "";
  return extensions->begin().key();
}

}  // namespace

const GltfTextures::Image& GltfTextures::decode(int index) {
  const auto [it, isNew] = images_.try_emplace(index);
  if (!isNew) return it->second;
  const std::string place = fmt::format("images[{}]", index);
  const tinygltf::Image image = decodeImage(file_, place, index);
  if (uint32_t(std::max(image.width, image.height)) > asset::kMaxTextureSize) {
    failAt(ExitCode::unsupported, file_.path, place, "{}x{} pixels are too many; at most {} a side",
           image.width, image.height, asset::kMaxTextureSize);
  }
  const size_t count = image.image.size() / 4, first = scene_.texels.size();
  if (first + count >= std::numeric_limits<uint32_t>::max()) {
    failAt(ExitCode::unsupported, file_.path, place,
           "the scene's textures pass 2^32 texels; use smaller images");
  }
  scene_.texels.resize(first + count);
  std::memcpy(scene_.texels.data() + first, image.image.data(),
              count * 4);  // little-endian: R in the low byte
  return it->second = {uint32_t(image.width), uint32_t(image.height), uint32_t(first)};
}

uint32_t GltfTextures::find(int index, bool srgb, const std::string& place) {
  const tinygltf::Texture& texture = file_.model.textures[size_t(index)];
  if (texture.source < 0) {
    const std::string extension = onlyExtension(file_.json["textures"][size_t(index)]);
    failAt(ExitCode::unsupported, file_.path, place, "textures[{}] has no PNG or JPEG image{}{}; {}", index,
           extension.empty() ? "" : ", only that of ", extension, conversionOf(extension));
  }
  const tinygltf::Sampler open;
  const tinygltf::Sampler& sampler =
      texture.sampler < 0 ? open : file_.model.samplers[size_t(texture.sampler)];
  const asset::Wrap wrapS = wrapOf(sampler.wrapS), wrapT = wrapOf(sampler.wrapT);
  const uint32_t magNearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  const uint32_t minFilter = minFilterOf(sampler.minFilter);
  const auto [it, isNew] =
      textures_.try_emplace({texture.source, wrapS, wrapT, uint32_t(srgb), magNearest, minFilter},
                            uint32_t(scene_.textures.size()));
  if (isNew) {
    const Image& image = decode(texture.source);
    scene_.textures.push_back({.width = image.width,
                               .height = image.height,
                               .firstTexel = image.firstTexel,
                               .wrapS = wrapS,
                               .wrapT = wrapT,
                               .srgb = srgb,
                               .magNearest = magNearest,
                               .minFilter = minFilter});
  }
  return it->second;
}

}  // namespace boxlight
