// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes.h"

#include <cmath>

namespace boxlight::test {
namespace {

asset::Vertex makeVertex(vec3 position, vec3 normal, vec2 uv) {
  vec3 tangent, bitangent;
  orthonormalBasis(normal, tangent, bitangent);
  asset::Vertex vertex{};
  for (int c = 0; c < 3; ++c) {
    vertex.position[c] = position[c];
    vertex.normal[c] = normal[c];
    vertex.tangent[c] = tangent[c];
  }
  vertex.tangent[3] = 1;
  for (auto* set : {vertex.atlasUv, vertex.uv[0], vertex.uv[1]}) set[0] = uv.x, set[1] = uv.y;
  for (float& c : vertex.color) c = 1;
  return vertex;
}

}  // namespace

asset::Material lambert(Rgb albedo) {
  asset::Material material;
  for (int c = 0; c < 3; ++c) material.baseColor[c] = albedo[c];
  material.metallic = 0;
  material.specular = 0;
  return material;
}

asset::Material metal(float roughness, Rgb colour) {
  asset::Material material;
  for (int c = 0; c < 3; ++c) material.baseColor[c] = colour[c];
  material.metallic = 1;
  material.roughness = roughness;
  return material;
}

Scene makeScene(const asset::Material& material) {
  Scene scene;
  scene.path = "test.glb";
  scene.materials.push_back(material);
  scene.hasTexcoord[0] = true;
  return scene;
}

void finish(Scene& scene) {
  scene.boundsMin = vec3(1e30f);
  scene.boundsMax = vec3(-1e30f);
  for (const asset::Vertex& v : scene.vertices) {
    const vec3 p(v.position[0], v.position[1], v.position[2]);
    scene.boundsMin = glm::min(scene.boundsMin, p);
    scene.boundsMax = glm::max(scene.boundsMax, p);
  }
}

void addQuad(Scene& scene, vec3 corner, vec3 u, vec3 v, vec2 uvMin, vec2 uvMax, uint32_t material) {
  const auto first = uint32_t(scene.vertices.size());
  const vec3 normal = glm::normalize(glm::cross(u, v));
  for (int k = 0; k < 4; ++k) {
    const vec2 st(k == 1 || k == 2, k >= 2);
    scene.vertices.push_back(makeVertex(corner + st.x * u + st.y * v, normal, glm::mix(uvMin, uvMax, st)));
  }
  scene.triangles.push_back({{first, first + 1, first + 2}, material});
  scene.triangles.push_back({{first, first + 2, first + 3}, material});
  finish(scene);
}

void addSphere(Scene& scene, vec3 centre, float radius, uint32_t segments, bool inward) {
  const auto first = uint32_t(scene.vertices.size());
  const uint32_t rows = segments / 2;
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= segments; ++i) {
      const vec2 uv(float(i) / float(segments), float(j) / float(rows));
      const float theta = kPi * uv.y, phi = 2 * kPi * uv.x;
      const vec3 outward(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
      scene.vertices.push_back(makeVertex(centre + radius * outward, inward ? -outward : outward, uv));
    }
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < segments; ++i) {
      const uint32_t a = first + j * (segments + 1) + i, b = a + segments + 1;
      auto add = [&](uint32_t p, uint32_t q, uint32_t r) {
        if (inward) std::swap(q, r);
        scene.triangles.push_back({{p, q, r}, 0});
      };
      if (j > 0) add(a, b, a + 1);
      if (j + 1 < rows) add(a + 1, b, b + 1);
    }
  finish(scene);
}

}  // namespace boxlight::test
