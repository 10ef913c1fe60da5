// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_material.h"

#include <bit>

#include "bake/scene/gltf_extensions.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

bool addsNothing(const asset::MaterialExtension& extension) {
  using Words = std::array<uint32_t, sizeof(asset::MaterialExtension) / sizeof(uint32_t)>;
  return std::bit_cast<Words>(extension) == std::bit_cast<Words>(asset::MaterialExtension());
}

uint32_t alphaFlags(const GltfMembers& source) {
  const nlohmann::json* mode = source.find("alphaMode");
  if (!mode || *mode == "OPAQUE") return 0;
  return *mode == "MASK" ? asset::kAlphaMask : asset::kAlphaBlend;
}

// KHR_materials_specular. A specularFactor of 0 on a dielectric leaves pure Lambert.
void readSpecular(const GltfMembers& specular, asset::Material& material) {
  material.specular = specular.fraction("specularFactor", 1.0);
  specular.numbers("specularColorFactor", material.specularColor, 0.0, kNoLimit);
  material.specularTexture = specular.texture("specularTexture", kLinear);
  material.specularColorTexture = specular.texture("specularColorTexture", kSrgb);
}

}  // namespace

std::string materialPlace(const GltfDocument& file, int material) {
  const std::string& name = file.model.materials[size_t(material)].name;
  if (name.empty()) return fmt::format("materials[{}]", material);
  return fmt::format("materials[{}] {}", material, nlohmann::json(name).dump());
}

uint32_t GltfMaterials::find(int index) {
  const auto [found, isNew] = found_.try_emplace(index, uint32_t(scene_.materials.size()));
  if (!isNew) return found->second;
  asset::Material material;
  asset::MaterialExtension extension;
  if (index >= 0) {
    const GltfMembers source(context_, &file_.json["materials"][size_t(index)], materialPlace(file_, index));
    material = convert(source);
    extension = readMaterialExtensions(source, material);
  }
  add(material, extension);
  return found->second;
}

void GltfMaterials::add(const asset::Material& material, const asset::MaterialExtension& extension) {
  scene_.materials.push_back(material);
  const bool plain = addsNothing(extension) && !(material.flags & asset::kExtensionFlags);
  if (plain && scene_.materialExtensions.empty()) return;
  scene_.materialExtensions.resize(scene_.materials.size());
  scene_.materialExtensions.back() = extension;
}

asset::Material GltfMaterials::convert(const GltfMembers& source) const {
  asset::Material material;
  const GltfMembers pbr = source.child("pbrMetallicRoughness");
  pbr.numbers("baseColorFactor", material.baseColor, 0.0, 1.0);
  material.metallic = pbr.fraction("metallicFactor", 1.0);
  material.roughness = pbr.fraction("roughnessFactor", 1.0);
  material.baseColorTexture = pbr.texture("baseColorTexture", kSrgb);
  material.metallicRoughnessTexture = pbr.texture("metallicRoughnessTexture", kLinear);
  material.normalTexture = source.texture("normalTexture", kLinear);
  material.normalScale = source.normalScale("normalTexture");
  material.alphaCutoff = source.number("alphaCutoff", 0.5, 0.0, kNoLimit);
  const nlohmann::json* doubleSided = source.find("doubleSided");
  material.flags = (doubleSided && *doubleSided ? asset::kDoubleSided : 0u) | alphaFlags(source);
  readSpecular(source.extension("KHR_materials_specular"), material);
  if (source.has("occlusionTexture"))
    log().debug("{}: {}.occlusionTexture: not needed, occlusion is traced", file_.path.string(),
                source.place());
  return material;
}

}  // namespace boxlight
