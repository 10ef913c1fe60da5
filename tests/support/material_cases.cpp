// SPDX-License-Identifier: Apache-2.0
#include "tests/support/material_cases.h"

#include <cmath>
#include <functional>

namespace boxlight::test {
namespace {

using Change = std::function<void(MaterialCase&)>;

MaterialCase make(std::string name, const Change& change) {
  MaterialCase result{std::move(name), {}};
  result.material.baseColor = {0.9f, 0.5f, 0.2f};
  change(result);
  return result;
}

void metal(MaterialCase& c, float alpha) {
  c.material.metallic = 1;
  c.material.roughness = std::sqrt(alpha);
}

void glass(MaterialCase& c, float alpha, float ior = 0, bool inside = false) {
  c.material.transmission = 1;
  c.material.roughness = std::sqrt(alpha);
  c.material.volume = ior > 0;
  c.interface = {ior, inside};
}

void coat(MaterialCase& c, float alpha, vec3 normal = {0, 0, 1}) {
  c.material.clearcoat = 1;
  c.material.clearcoatRoughness = std::sqrt(alpha);
  c.coatNormal = glm::normalize(normal);
}

void anisotropic(MaterialCase& c, float strength) {
  c.material.anisotropy = strength;
  c.azimuth = 0.7f;
}

void sheen(MaterialCase& c, float roughness) {
  c.material.sheenColor = {0.8f, 0.6f, 1};
  c.material.sheenRoughness = roughness;
}

void leaf(MaterialCase& c) {
  c.material.diffuseTransmission = 0.6f;
  c.material.diffuseTransmissionColor = {0.3f, 0.9f, 0.2f};
}

std::vector<MaterialCase> makeCases() {
  std::vector<MaterialCase> cases;
  const auto add = [&](const std::string& name, const Change& change) {
    cases.push_back(make(name, change));
  };
  add("diffuse", [](auto& c) { c.material.specular = 0; });
  add("diffuse transmission", [](auto& c) { c.material.specular = 0, leaf(c); });
  for (const float alpha : {1e-4f, 1e-3f, 0.01f, 0.1f, 0.5f, 1.0f}) {
    const std::string at = " " + std::to_string(alpha);
    add("metal" + at, [&](auto& c) { metal(c, alpha); });
    add("dielectric" + at, [&](auto& c) { c.material.roughness = std::sqrt(alpha); });
    add("thin glass" + at, [&](auto& c) { glass(c, alpha); });
    add("glass entered" + at, [&](auto& c) { glass(c, alpha, 1.5f); });
    add("glass left" + at, [&](auto& c) { glass(c, alpha, 1 / 1.5f, true); });
  }
  add("metal multi", [](auto& c) { metal(c, 0.6f), c.material.multipleScattering = true; });
  add("brushed metal", [](auto& c) { metal(c, 0.01f), anisotropic(c, 0.5f); });
  add("brushed across", [](auto& c) { metal(c, 0.05f), anisotropic(c, 1), c.azimuth = 1.5f; });
  add("brushed thin glass", [](auto& c) { glass(c, 0.1f), anisotropic(c, 0.7f); });
  add("brushed glass", [](auto& c) { glass(c, 0.1f, 1.5f), anisotropic(c, 0.7f); });
  add("thick liquid", [](auto& c) { glass(c, 0.2f, 1.05f); });
  add("diamond left", [](auto& c) { glass(c, 0.1f, 1 / 2.4f, true); });
  add("sheen", [](auto& c) { sheen(c, 0.5f), c.material.specular = 0; });
  add("smooth sheen on metal", [](auto& c) { sheen(c, 0.1f), metal(c, 0.2f); });
  add("coat", [](auto& c) { coat(c, 0.001f), metal(c, 0.3f); });
  add("tilted coat", [](auto& c) { coat(c, 0.02f, {0.5f, 0.2f, 1}), metal(c, 0.3f); });
  add("tilted rough coat on a leaf", [](auto& c) { coat(c, 0.3f, {0.8f, -0.3f, 1}), leaf(c); });
  add("rough leaf", [](auto& c) { leaf(c), c.material.roughness = 0.6f; });
  add("film", [](auto& c) { c.material.iridescence = 1, c.material.roughness = 0.4f; });
  add("film on metal", [](auto& c) { c.material.iridescence = 1, metal(c, 0.04f); });
  add("everything", [](auto& c) {
    c.material.metallic = 0.3f, c.material.roughness = 0.5f, c.material.transmission = 0.5f;
    leaf(c), sheen(c, 0.6f), coat(c, 0.01f, {0.2f, 0.1f, 1}), anisotropic(c, 0.4f);
    c.material.clearcoat = 0.7f;
  });
  add("everything in a volume", [](auto& c) {
    c.material.metallic = 0.3f, leaf(c), sheen(c, 0.6f), coat(c, 0.01f);
    glass(c, 0.1f, 1.4f), c.material.transmission = 0.5f, anisotropic(c, 0.4f);
  });
  return cases;
}

}  // namespace

const std::vector<MaterialCase>& materialCases() {
  static const std::vector<MaterialCase> cases = makeCases();
  return cases;
}

}  // namespace boxlight::test
