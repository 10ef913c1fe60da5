// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "bake/scene/scene.h"

namespace boxlight {

/// Brings the KHR_texture_transform of texture references into a scene, each different one once. The scene
/// must outlive it.
class GltfTextureTransforms {
 public:
  GltfTextureTransforms(const std::filesystem::path& path, Scene& scene) : path_(path), scene_(scene) {}

  /// TextureRef::transform of a textureInfo, 0 where nothing is transformed. `place` names it in messages.
  /// Errors: invalidInput if a number is beyond +-1e6, unsupported past 65535 different transforms.
  uint16_t find(const nlohmann::json& textureInfo, const std::string& place);

 private:
  const std::filesystem::path& path_;
  Scene& scene_;
  std::map<std::array<float, 6>, uint16_t> found_;  // by rows
};

/// The set of texture coordinates that a textureInfo reads, which KHR_texture_transform may override.
uint64_t texcoordOf(const nlohmann::json& textureInfo);

}  // namespace boxlight
