// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_members.h"

#include <algorithm>
#include <limits>

#include "bake/scene/gltf_error.h"
#include "common/base/log.h"

namespace boxlight {

static_assert(kNoLimit == double(std::numeric_limits<float>::max()));

const nlohmann::json* GltfMembers::find(const char* key) const {
  if (!object_ || !object_->is_object()) return nullptr;
  const auto found = object_->find(key);
  return found == object_->end() ? nullptr : &*found;
}

GltfMembers GltfMembers::child(const char* key) const {
  return {context_, find(key), fmt::format("{}.{}", place_, key)};
}

void GltfMembers::say(const std::string& place, const std::string& message) const {
  log().warn("{}: {}: {}", context_.file.path.string(), place, message);
}

float GltfMembers::inRange(const char* key, double value, double low, double high) const {
  const double clamped = std::clamp(value, low, high);
  if (clamped != value) warn(key, "{} is out of range, {} is used", value, clamped);
  return float(clamped);
}

float GltfMembers::number(const char* key, double otherwise, double low, double high) const {
  const nlohmann::json* value = find(key);
  return value ? inRange(key, value->get<double>(), low, high) : float(otherwise);
}

bool GltfMembers::numbers(const char* key, float* values, size_t count, double low, double high) const {
  const nlohmann::json* array = find(key);
  if (!array) return false;
  for (size_t i = 0; i < count; ++i) values[i] = inRange(key, (*array)[i].get<double>(), low, high);
  return true;
}

asset::TextureRef GltfMembers::texture(const char* key, bool srgb) const {
  const nlohmann::json* info = find(key);
  if (!info) return {};
  const std::string here = fmt::format("{}.{}", place_, key);
  const uint64_t texcoord = texcoordOf(*info);
  if (texcoord > 1) {
    failAt(ExitCode::unsupported, context_.file.path, here + ".texCoord",
           "TEXCOORD_{} is not supported; use set 0 or 1", texcoord);
  }
  const uint32_t texture = context_.textures.find((*info)["index"], srgb, here);
  return {texture, uint16_t(texcoord), context_.transforms.find(*info, here)};
}

float GltfMembers::normalScale(const char* key) const {
  return child(key).number("scale", 1.0, -kNoLimit, kNoLimit);
}

}  // namespace boxlight
