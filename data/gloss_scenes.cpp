// SPDX-License-Identifier: Apache-2.0
#include "data/gloss_scenes.h"

#include <cmath>

namespace boxlight::data {
namespace {

Material gloss(const char* name, Rgb color, float metallic, float alpha) {
  Material material;
  material.name = name;
  material.baseColor = color;
  material.metallic = metallic;
  material.roughness = std::sqrt(alpha);
  return material;
}

Material lambert(const char* name, Rgb albedo) {
  Material material = gloss(name, albedo, 0, 1);
  material.specular = 0;
  return material;
}

Part ball(Material material, vec3 centre, float radius) {
  const std::string name = material.name + " ball";
  return {name, std::move(material), {sphereChart(centre, radius, {0, kPi}, 96, 48)}};
}

/// Point on the (2,3) torus knot, t a turn.
vec3 knotCentre(float t) {
  const float angle = 2 * kPi * t, radius = 2 + std::cos(3 * angle);
  return 0.8f * vec3(radius * std::cos(2 * angle), std::sin(3 * angle), radius * std::sin(2 * angle)) +
         vec3(0, 1.9f, 0);
}

/// The part [first, last] of the knot's tube, once around.
Chart knotTube(float first, float last, uint32_t segments) {
  constexpr float kTube = 0.33f, kStep = 1e-3f;
  const float length = glm::length(knotCentre(last) - knotCentre(first));
  return gridChart(segments, 32, {1.2f * length, 2 * kPi * kTube},
                   [&](float u, float v, vec3& position, vec3& normal) {
                     const float t = first + (last - first) * u, angle = 2 * kPi * v;
                     const vec3 centre = knotCentre(t);
                     const vec3 along = glm::normalize(knotCentre(t + kStep) - knotCentre(t - kStep));
                     const vec3 side = glm::normalize(glm::cross(along, vec3(centre.x, 0, centre.z)));
                     normal = std::cos(angle) * side + std::sin(angle) * glm::cross(side, along);
                     position = centre + kTube * normal;
                   });
}

Part knot(Material material) {
  constexpr uint32_t kCharts = 16;
  Part part{"knot", std::move(material), {}};
  for (uint32_t k = 0; k < kCharts; ++k)
    part.charts.push_back(knotTube(float(k) / kCharts, float(k + 1) / kCharts, 400 / kCharts));
  return part;
}

Part ground(float radius, Rgb albedo) {
  return {"ground", lambert("ground", albedo), {discChart({0, 0, 0}, radius, 64, 4, true)}};
}

Model makeKnot(const Parameters&) {
  Model model;
  model.parts = {ground(5, {0.55f, 0.5f, 0.45f}),
                 knot(gloss("gold", {1.0f, 0.77f, 0.34f}, 1, 0.15f)),
                 ball(lambert("red", {0.8f, 0.15f, 0.1f}), {2.9f, 0.8f, 1.2f}, 0.8f),
                 ball(gloss("chrome", {0.9f, 0.9f, 0.92f}, 1, 0.02f), {-2.6f, 0.9f, 1.9f}, 0.9f),
                 ball(gloss("blue", {0.1f, 0.3f, 0.8f}, 0, 0.1f), {-1.5f, 0.7f, -3.0f}, 0.7f),
                 ball(gloss("copper", {0.95f, 0.64f, 0.54f}, 1, 0.4f), {1.9f, 1.0f, -2.6f}, 1.0f),
                 ball(gloss("green", {0.2f, 0.7f, 0.2f}, 0, 0.03f), {0, 0.6f, 3.2f}, 0.6f)};
  return model;
}

/// A ring of columns under a flat roof.
Part columns(uint32_t count, float ring, float height) {
  Part part{"columns", lambert("stone", {0.7f, 0.65f, 0.58f}), {}};
  for (uint32_t k = 0; k < count; ++k) {
    const float angle = 2 * kPi * float(k) / float(count);
    part.charts.push_back(
        cylinderChart({ring * std::cos(angle), 0, ring * std::sin(angle)}, 0.25f, height, 24));
  }
  const float eaves = ring + 0.4f, thickness = 0.2f;
  part.charts.push_back(discChart({0, height, 0}, eaves, 64, 4, false));
  part.charts.push_back(discChart({0, height + thickness, 0}, eaves, 64, 4, true));
  part.charts.push_back(cylinderChart({0, height, 0}, eaves, thickness, 64));
  return part;
}

Model makeColonnade(const Parameters&) {
  Model model;
  model.parts = {ground(5, {0.4f, 0.42f, 0.38f}),
                 columns(10, 2.4f, 3.0f),
                 ball(gloss("chrome", {0.9f, 0.9f, 0.92f}, 1, 0.02f), {0, 0.9f, 0}, 0.8f),
                 ball(gloss("gold", {1.0f, 0.77f, 0.34f}, 1, 0.3f), {-1.4f, 0.45f, 0.7f}, 0.45f),
                 ball(gloss("steel", {0.56f, 0.57f, 0.58f}, 1, 0.1f), {1.3f, 0.4f, 0.9f}, 0.4f),
                 ball(gloss("blue", {0.1f, 0.3f, 0.8f}, 0, 0.05f), {0.3f, 0.35f, -1.5f}, 0.35f)};
  return model;
}

}  // namespace

const std::vector<SceneRecipe>& glossSceneRecipes() {
  static const std::vector<SceneRecipe> recipes = {
      {"knot", "torus knot and five balls of every gloss on a ground", {}, makeKnot},
      {"colonnade", "balls of every gloss among ten columns under a roof", {}, makeColonnade}};
  return recipes;
}

}  // namespace boxlight::data
