// SPDX-License-Identifier: Apache-2.0
#include "tests/support/material_scenes.h"

#include <functional>

namespace boxlight::test {
namespace {

using Change = std::function<void(asset::Material&, asset::MaterialExtension&)>;

SceneMaterial make(std::string name, const Change& change) {
  SceneMaterial result{std::move(name), lambert({0.8f, 0.5f, 0.2f}), {}};
  result.material.specular = 1;
  result.material.roughness = 0.6f;
  result.material.flags = asset::kDoubleSided;
  change(result.material, result.extension);
  return result;
}

void set(float (&target)[3], Rgb value) {
  for (int c = 0; c < 3; ++c) target[c] = value[c];
}

std::vector<SceneMaterial> makeAll() {
  return {
      make("diffuse", [](auto& m, auto&) { m.specular = 0; }),
      make("dielectric", [](auto&, auto&) {}),
      make("metal", [](auto& m, auto&) { m.metallic = 1; }),
      make("metal_multi", [](auto& m, auto&) { m.metallic = 1, m.flags |= asset::kMultipleScattering; }),
      make("brushed",
           [](auto& m, auto& x) { m.metallic = 1, x.anisotropy = 0.7f, x.anisotropyRotation = 0.5f; }),
      make("coat", [](auto& m, auto& x) { m.metallic = 1, x.clearcoat = 0.8f, x.clearcoatRoughness = 0.5f; }),
      make("sheen",
           [](auto&, auto& x) {
             set(x.sheenColor, {0.9f, 0.4f, 0.7f}), x.sheenRoughness = 0.6f;
           }),
      make("thin_glass", [](auto&, auto& x) { x.transmission = 0.8f, x.ior = 1.8f; }),
      make("leaf",
           [](auto&, auto& x) {
             x.diffuseTransmission = 0.7f, set(x.diffuseTransmissionColor, {0.2f, 0.9f, 0.4f});
           }),
      make("film",
           [](auto& m, auto& x) { m.metallic = 0.5f, x.iridescence = 1, x.iridescenceThickness[1] = 450; }),
      make("emitter",
           [](auto&, auto& x) {
             set(x.emissive, {0.5f, 1, 2}), x.clearcoat = 1, x.clearcoatRoughness = 0.7f;
           }),
      make("unlit", [](auto& m, auto&) { m.flags |= asset::kUnlit; }),
  };
}

}  // namespace

Scene SceneMaterial::scene() const {
  Scene scene = makeScene(material);
  scene.materialExtensions.push_back(extension);
  return scene;
}

const std::vector<SceneMaterial>& sceneMaterials() {
  static const std::vector<SceneMaterial> all = makeAll();
  return all;
}

SceneMaterial glassVolume(float roughness) {
  return make("glass", [&](auto& m, auto& x) {
    m = lambert();
    m.specular = 1, m.roughness = roughness, m.flags = asset::kVolume, x.transmission = 1;
  });
}

}  // namespace boxlight::test
