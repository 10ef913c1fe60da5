// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "bake/scene/gltf_document.h"
#include "bake/scene/scene.h"

namespace boxlight {

/// Brings textures of a document into a scene, on first use: texels once per image, a record once per image,
/// sampler and colour space. The document and the scene must outlive it.
class GltfTextures {
 public:
  GltfTextures(const GltfDocument& file, Scene& scene) : file_(file), scene_(scene) {}

  /// Index into Scene::textures. `place` names the use in messages. Errors: invalidInput if the image is
  /// missing or cannot be decoded, unsupported if it is of a kind that only an extension allows or if all
  /// texels pass 2^32.
  uint32_t find(int texture, bool srgb, const std::string& place);

 private:
  struct Image {
    uint32_t width, height, firstTexel;
  };
  const Image& decode(int image);

  const GltfDocument& file_;
  Scene& scene_;
  std::map<int, Image> images_;
  // image, wrapS, wrapT, srgb, magNearest, minFilter
  std::map<std::tuple<int, asset::Wrap, asset::Wrap, uint32_t, uint32_t, uint32_t>, uint32_t> textures_;
};

}  // namespace boxlight
