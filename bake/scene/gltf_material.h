// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "bake/scene/gltf_texture.h"

namespace boxlight {

/// materials[i] ("its name"), as messages name it.
std::string materialPlace(const GltfDocument& file, int material);

/// Brings materials of a document into a scene, on first use. The document and the scene must outlive it.
class GltfMaterials {
 public:
  GltfMaterials(const GltfDocument& file, Scene& scene)
      : file_(file), scene_(scene), textures_(file, scene) {}

  /// Index into Scene::materials; -1 is glTF's default material. Factors outside their range are clamped and
  /// emission is ignored, each with a warning. Errors: unsupported for alphaMode BLEND and texture coordinate
  /// sets above 1, and those of GltfTextures::find.
  uint32_t find(int material);

 private:
  asset::Material convert(int material);
  asset::TextureRef reference(int texture, int texcoord, bool srgb, const std::string& place);
  float inRange(double value, double high, const std::string& place) const;
  void convertSpecular(int material, const std::string& place, asset::Material& converted);

  const GltfDocument& file_;
  Scene& scene_;
  GltfTextures textures_;
  std::map<int, uint32_t> found_;
};

}  // namespace boxlight
