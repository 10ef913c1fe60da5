// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "bake/scene/gltf_members.h"

namespace boxlight {

/// materials[i] ("its name"), as messages name it.
std::string materialPlace(const GltfDocument& file, int material);

/// Brings materials of a document into a scene, on first use. The document and the scene must outlive it.
class GltfMaterials {
 public:
  GltfMaterials(const GltfDocument& file, Scene& scene) : file_(file), scene_(scene), context_(file, scene) {}

  /// Index into Scene::materials; -1 is glTF's default material. Scene::materialExtensions is filled from the
  /// first material on that has any. Factors outside their range are clamped with a warning. Errors:
  /// those of GltfMembers::texture.
  uint32_t find(int material);

 private:
  asset::Material convert(const GltfMembers& source) const;
  void add(const asset::Material& material, const asset::MaterialExtension& extension);

  const GltfDocument& file_;
  Scene& scene_;
  GltfMaterialContext context_;
  std::map<int, uint32_t> found_;
};

}  // namespace boxlight
