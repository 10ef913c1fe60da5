// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_material.h"

#include <algorithm>
#include <limits>

#include "bake/scene/gltf_error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

constexpr bool kSrgb = true, kLinear = false;
constexpr double kNoLimit = std::numeric_limits<float>::max();

}  // namespace

std::string materialPlace(const GltfDocument& file, int material) {
  const std::string& name = file.model.materials[size_t(material)].name;
  if (name.empty()) return fmt::format("materials[{}]", material);
  return fmt::format("materials[{}] {}", material, nlohmann::json(name).dump());
}

uint32_t GltfMaterials::find(int material) {
  const auto found = found_.find(material);
  if (found != found_.end()) return found->second;
  const asset::Material converted = material < 0 ? asset::Material() : convert(material);
  scene_.materials.push_back(converted);
  return found_[material] = uint32_t(scene_.materials.size() - 1);
}

asset::TextureRef GltfMaterials::reference(int texture, int texcoord, bool srgb, const std::string& place) {
  if (texture < 0) return {};
  if (texcoord > 1) {
    failAt(ExitCode::unsupported, file_.path, place + ".texCoord",
           "TEXCOORD_{} is not supported; use set 0 or 1", texcoord);
  }
  return {textures_.find(texture, srgb, place), uint16_t(texcoord)};
}

// A factor of 0 to `high`.
float GltfMaterials::inRange(double value, double high, const std::string& place) const {
  const double clamped = std::clamp(value, 0.0, high);
  if (clamped != value)
    log().warn("{}: {}: {} is out of range, {} is used", file_.path.string(), place, value, clamped);
  return float(clamped);
}

asset::Material GltfMaterials::convert(int index) {
  const tinygltf::Material& source = file_.model.materials[size_t(index)];
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::string place = materialPlace(file_, index), pbrPlace = place + ".pbrMetallicRoughness";
  if (source.alphaMode == "BLEND") {
    failAt(ExitCode::unsupported, file_.path, place + ".alphaMode",
           "BLEND is not supported; use MASK or OPAQUE");
  }
  if (std::ranges::any_of(source.emissiveFactor, [](double e) { return e != 0.0; })) {
    log().warn("{}: {}.emissiveFactor: emission is ignored", file_.path.string(), place);
  }
  if (source.occlusionTexture.index >= 0) {
    log().debug("{}: {}.occlusionTexture: not needed, occlusion is traced", file_.path.string(), place);
  }
  asset::Material material;
  for (size_t i = 0; i < 4; ++i) {
    material.baseColor[i] = inRange(pbr.baseColorFactor[i], 1.0, pbrPlace + ".baseColorFactor");
  }
  material.metallic = inRange(pbr.metallicFactor, 1.0, pbrPlace + ".metallicFactor");
  material.roughness = inRange(pbr.roughnessFactor, 1.0, pbrPlace + ".roughnessFactor");
  material.normalScale = float(std::clamp(source.normalTexture.scale, -kNoLimit, kNoLimit));
  material.alphaCutoff = inRange(source.alphaCutoff, kNoLimit, place + ".alphaCutoff");
  material.flags =
      (source.doubleSided ? asset::kDoubleSided : 0u) | (source.alphaMode == "MASK" ? asset::kAlphaMask : 0u);
  material.baseColorTexture = reference(pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord, kSrgb,
                                        pbrPlace + ".baseColorTexture");
  material.metallicRoughnessTexture =
      reference(pbr.metallicRoughnessTexture.index, pbr.metallicRoughnessTexture.texCoord, kLinear,
                pbrPlace + ".metallicRoughnessTexture");
  material.normalTexture =
      reference(source.normalTexture.index, source.normalTexture.texCoord, kLinear, place + ".normalTexture");
  convertSpecular(index, place, material);
  return material;
}

// KHR_materials_specular, checked by checkDocument. A specularFactor of 0 on a dielectric leaves pure
// Lambert.
void GltfMaterials::convertSpecular(int index, const std::string& place, asset::Material& material) {
  const nlohmann::json& source = file_.json["materials"][size_t(index)];
  const nlohmann::json::json_pointer pointer("/extensions/KHR_materials_specular");
  if (!source.contains(pointer)) return;
  const nlohmann::json& extension = source[pointer];
  const std::string here = place + ".extensions.KHR_materials_specular.";
  material.specular = inRange(extension.value("specularFactor", 1.0), 1.0, here + "specularFactor");
  if (extension.contains("specularColorFactor")) {
    for (size_t i = 0; i < 3; ++i) {
      material.specularColor[i] =
          inRange(extension["specularColorFactor"][i], kNoLimit, here + "specularColorFactor");
    }
  }
  const auto texture = [&](const char* key, bool srgb) {
    if (!extension.contains(key)) return asset::TextureRef();
    return reference(extension[key]["index"], extension[key].value("texCoord", 0), srgb, here + key);
  };
  material.specularTexture = texture("specularTexture", kLinear);
  material.specularColorTexture = texture("specularColorTexture", kSrgb);
}

}  // namespace boxlight
