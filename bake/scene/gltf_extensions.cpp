// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_extensions.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bake/scene/gltf_scatter.h"
#include "bake/scene/gltf_support.h"

namespace boxlight {
namespace {

using asset::MaterialExtension;

bool isBlack(const float (&color)[3]) {
  return std::all_of(std::begin(color), std::end(color), [](float c) { return c == 0.0f; });
}

// 0 is allowed and makes F0 one (KHR_materials_ior); between it and 1 nothing is.
void readIor(const GltfMembers& ior, MaterialExtension& x) {
  const nlohmann::json* value = ior.find("ior");
  x.ior = value && *value == 0.0 ? 0.0f : ior.number("ior", 1.5, 1.0, kNoLimit);
}

void readAnisotropy(const GltfMembers& anisotropy, MaterialExtension& x) {
  const float strength = anisotropy.fraction("anisotropyStrength", 0.0);
  if (strength == 0.0f) return;
  x.anisotropy = strength;
  x.anisotropyRotation = anisotropy.number("anisotropyRotation", 0.0, -kNoLimit, kNoLimit);
  x.anisotropyTexture = anisotropy.texture("anisotropyTexture", kLinear);
}

void readClearcoat(const GltfMembers& coat, MaterialExtension& x) {
  const float factor = coat.fraction("clearcoatFactor", 0.0);
  if (factor == 0.0f) return;
  x.clearcoat = factor;
  x.clearcoatTexture = coat.texture("clearcoatTexture", kLinear);
  x.clearcoatRoughness = coat.fraction("clearcoatRoughnessFactor", 0.0);
  x.clearcoatRoughnessTexture = coat.texture("clearcoatRoughnessTexture", kLinear);
  x.clearcoatNormalTexture = coat.texture("clearcoatNormalTexture", kLinear);
  x.clearcoatNormalScale = coat.normalScale("clearcoatNormalTexture");
}

void readSheen(const GltfMembers& sheen, MaterialExtension& x) {
  sheen.numbers("sheenColorFactor", x.sheenColor, 0.0, 1.0);
  if (isBlack(x.sheenColor)) return;
  x.sheenColorTexture = sheen.texture("sheenColorTexture", kSrgb);
  x.sheenRoughness = sheen.fraction("sheenRoughnessFactor", 0.0);
  x.sheenRoughnessTexture = sheen.texture("sheenRoughnessTexture", kLinear);
}

void readTransmission(const GltfMembers& transmission, MaterialExtension& x) {
  const float factor = transmission.fraction("transmissionFactor", 0.0);
  if (factor == 0.0f) return;
  x.transmission = factor;
  x.transmissionTexture = transmission.texture("transmissionTexture", kLinear);
}

void readDiffuseTransmission(const GltfMembers& transmission, MaterialExtension& x) {
  const float factor = transmission.fraction("diffuseTransmissionFactor", 0.0);
  if (factor == 0.0f) return;
  x.diffuseTransmission = factor;
  x.diffuseTransmissionTexture = transmission.texture("diffuseTransmissionTexture", kLinear);
  transmission.numbers("diffuseTransmissionColorFactor", x.diffuseTransmissionColor, 0.0, 1.0);
  x.diffuseTransmissionColorTexture = transmission.texture("diffuseTransmissionColorTexture", kSrgb);
}

void readIridescence(const GltfMembers& film, MaterialExtension& x) {
  const float factor = film.fraction("iridescenceFactor", 0.0);
  if (factor == 0.0f) return;
  x.iridescence = factor;
  x.iridescenceTexture = film.texture("iridescenceTexture", kLinear);
  x.iridescenceIor = film.number("iridescenceIor", 1.3, 1.0, kNoLimit);
  x.iridescenceThickness[0] = film.number("iridescenceThicknessMinimum", 100.0, 0.0, kNoLimit);
  x.iridescenceThickness[1] = film.number("iridescenceThicknessMaximum", 400.0, 0.0, kNoLimit);
  x.iridescenceThicknessTexture = film.texture("iridescenceThicknessTexture", kLinear);
}

// The core's emission with KHR_materials_emissive_strength.
void readEmission(const GltfMembers& source, MaterialExtension& x) {
  source.numbers("emissiveFactor", x.emissive, 0.0, 1.0);
  const float strength =
      source.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1.0, 0.0, kNoLimit);
  for (float& channel : x.emissive) channel *= strength;
  if (!isBlack(x.emissive)) x.emissiveTexture = source.texture("emissiveTexture", kSrgb);
}

void warnOfIgnored(const GltfMembers& source) {
  std::vector<std::string> names;
  for (const auto& [name, value] : source.find("extensions")->items())
    if (name != "KHR_materials_unlit" && isSupportedExtension(name)) names.push_back(name);
  if (!names.empty())
    source.warn("extensions", "KHR_materials_unlit leaves no place for {}; ignored", fmt::join(names, ", "));
}

}  // namespace

MaterialExtension readMaterialExtensions(const GltfMembers& source, asset::Material& material) {
  MaterialExtension x;
  if (source.extension("KHR_materials_unlit")) {
    material.flags |= asset::kUnlit;
    warnOfIgnored(source);
    return x;
  }
  readIor(source.extension("KHR_materials_ior"), x);
  readAnisotropy(source.extension("KHR_materials_anisotropy"), x);
  readClearcoat(source.extension("KHR_materials_clearcoat"), x);
  readSheen(source.extension("KHR_materials_sheen"), x);
  readTransmission(source.extension("KHR_materials_transmission"), x);
  readDiffuseTransmission(source.extension("KHR_materials_diffuse_transmission"), x);
  readIridescence(source.extension("KHR_materials_iridescence"), x);
  readEmission(source, x);
  if (readMedium(source, x)) material.flags |= asset::kVolume;
  return x;
}

}  // namespace boxlight
