// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_texture_transform.h"

#include <bit>
#include <cmath>

#include "bake/scene/gltf_error.h"

namespace boxlight {
namespace {

using Json = nlohmann::json;

// Coordinates up to 1e30 times this are still numbers.
constexpr double kMaxNumber = 1e6;

const Json& transformOf(const Json& textureInfo) {
  static const Json none = Json::object();
  static const Json::json_pointer pointer("/extensions/KHR_texture_transform");
  return textureInfo.contains(pointer) ? textureInfo[pointer] : none;
}

}  // namespace

uint64_t texcoordOf(const Json& textureInfo) {
  return transformOf(textureInfo).value("texCoord", textureInfo.value("texCoord", uint64_t(0)));
}

// Translation times rotation times scale. Counter-clockwise as seen in the image, in which v grows downwards:
// the specification's own example, a quarter turn, shows the lower left quadrant only with this sign.
uint16_t GltfTextureTransforms::find(const Json& textureInfo, const std::string& place) {
  const Json& transform = transformOf(textureInfo);
  const auto number = [&](const Json& value) {
    if (std::abs(value.get<double>()) <= kMaxNumber) return value.get<double>();
    failAt(ExitCode::invalidInput, path_, place + ".extensions.KHR_texture_transform",
           "{} is beyond 1e6; export the file again", value.dump());
  };
  const auto pair = [&](const char* key, double otherwise) {
    const auto found = transform.find(key);
    if (found == transform.end()) return glm::dvec2(otherwise);
    return glm::dvec2(number((*found)[0]), number((*found)[1]));
  };
  const glm::dvec2 offset = pair("offset", 0.0), scale = pair("scale", 1.0);
  const double rotation = transform.contains("rotation") ? number(transform["rotation"]) : 0.0;
  const double c = std::cos(rotation), s = std::sin(rotation);
  const asset::TextureTransform rows{{{float(c * scale.x), float(s * scale.y), float(offset.x)},
                                      {float(-s * scale.x), float(c * scale.y), float(offset.y)}}};
  auto key = std::bit_cast<std::array<float, 6>>(rows);
  for (float& value : key) value += 0.0f;  // -0 is 0
  if (key == std::array{1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) return 0;
  const auto [it, isNew] = found_.try_emplace(key, uint16_t(scene_.textureTransforms.size() + 1));
  if (isNew && scene_.textureTransforms.size() == asset::kMaxTextureTransforms)
    failAt(ExitCode::unsupported, path_, place, "more than {} different texture transforms",
           asset::kMaxTextureTransforms);
  if (isNew) scene_.textureTransforms.push_back(std::bit_cast<asset::TextureTransform>(key));
  return it->second;
}

}  // namespace boxlight
