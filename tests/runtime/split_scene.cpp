// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/split_scene.h"

#include <cmath>

#include "common/light/film_lobe.h"
#include "common/light/light_domain.h"
#include "tests/runtime/pixel_model.h"

namespace boxlight {

VisibilityMap openMap() {
  VisibilityMap map;
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) map.setVisible(x, y);
  return map;
}

VisibilityMap spottedMap(uint32_t record) {
  VisibilityMap map;
  const float turn = 0.2f * float(record % kEdge) + 0.1f * float(record / kEdge);
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) {
      const vec3 d = uvToDirection((vec2(x, y) + 0.5f) / vec2(VisibilityMap::kColumns, VisibilityMap::kRows));
      if (std::sin(5 * d.x + turn) + std::sin(4 * d.z + 3 * turn) + std::sin(3 * d.y) < 1.0f)
        map.setVisible(x, y);
    }
  return map;
}

Image skyEnvironment() {
  Image image = makeImage(256, 128, 3);
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const vec3 d = uvToDirection((vec2(x, y) + 0.5f) / vec2(image.width, image.height));
      const float sun = glm::dot(d, glm::normalize(vec3(0.3f, 0.8f, -0.5f))) > 0.995f ? 50.0f : 0.0f;
      const Rgb color = Rgb(1 + d.x, 1 + 0.5f * d.y, 1 - 0.5f * d.z) + sun;
      std::copy_n(&color.x, 3, image.at(x, y));
    }
  return image;
}

Finish metal(float roughness, float anisotropy, float rotation) {
  Finish finish;
  finish.material.roughness = roughness;
  finish.material.baseColor[1] = 0.7f;
  finish.material.baseColor[2] = 0.3f;
  finish.extension.anisotropy = anisotropy;
  finish.extension.anisotropyRotation = rotation;
  return finish;
}

Finish brushed() {
  Finish finish = metal(0.25f, 0.7f, 0.5f);
  finish.extension.anisotropyTexture = {0, 0, 0};
  finish.direction = glm::normalize(vec2(0x40, 0xE0) / 127.5f - 1.0f);
  return finish;
}

Finish varnish(float roughness) {
  Finish finish = metal(roughness);
  finish.material.metallic = 0;
  return finish;
}

Finish coated(float roughness) {
  Finish finish = metal(roughness);
  finish.extension.clearcoat = 0.8f;
  finish.extension.clearcoatRoughness = 0.3f;
  return finish;
}

Finish velvet() {
  Finish finish = varnish(0.3f);
  finish.extension.sheenColor[0] = finish.extension.sheenColor[1] = 0.5f;
  finish.extension.sheenRoughness = 0.4f;
  return finish;
}

Finish filmedMetal(float roughness) {
  Finish finish = metal(roughness);
  std::fill_n(finish.material.baseColor, 3, 0.35f);
  finish.extension.iridescence = 1;
  finish.extension.iridescenceIor = 1.8f;
  finish.extension.iridescenceThickness[1] = 480;
  return finish;
}

Finish filmedVarnish(float roughness) {
  Finish finish = varnish(roughness);
  finish.extension.iridescence = 0.9f;
  finish.extension.iridescenceIor = 1.3f;
  finish.extension.iridescenceThickness[1] = 400;
  return finish;
}

Finish frosted() {
  Finish finish = varnish(0.5f);
  finish.extension.transmission = 0.7f;
  return finish;
}

GgxLobe lobeOf(const Finish& finish, vec3 view) {
  const auto& m = finish.material;
  GgxLobe lobe;
  lobe.normal = {0, 1, 0};
  lobe.view = view;
  const float rotation = finish.extension.anisotropyRotation, strength = finish.extension.anisotropy;
  const vec2 d = finish.direction;
  const float c = std::cos(rotation), s = std::sin(rotation);
  lobe.tangent = strength > 0 ? vec3(c * d.x - s * d.y, 0, s * d.x + c * d.y)  // bitangent +Z
                              : lobeTangent(lobe.normal, view);
  lobe.bitangent = glm::cross(lobe.normal, lobe.tangent);
  const float alpha = m.roughness * m.roughness;
  lobe.alpha = {glm::mix(alpha, 1.0f, strength * strength), alpha};
  const Rgb color(m.baseColor[0], m.baseColor[1], m.baseColor[2]);
  lobe.f0 = m.metallic > 0 ? color : Rgb(0.04f * m.specular);
  lobe.f90 = Rgb(m.metallic > 0 ? 1.0f : m.specular);
  if (finish.extension.iridescence > 0)
    fitFresnel(lobe, [&](float vDotH) { return baseFresnel(m, finish.extension, vDotH); });
  return lobe;
}

GgxLobe coatOf(const Finish& finish, vec3 view) {
  GgxLobe lobe;
  lobe.normal = {0, 1, 0};
  lobe.view = view;
  lobe.tangent = lobeTangent(lobe.normal, view);
  lobe.bitangent = glm::cross(lobe.normal, lobe.tangent);
  lobe.alpha = vec2(finish.extension.clearcoatRoughness * finish.extension.clearcoatRoughness);
  return lobe;
}

}  // namespace boxlight
