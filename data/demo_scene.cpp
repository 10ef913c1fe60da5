// SPDX-License-Identifier: Apache-2.0
#include "data/demo_scene.h"

#include "data/teapot.h"

namespace boxlight::data {
namespace {

constexpr float kMetresPerUnit = 0.05f;  ///< of Newell's units
constexpr float kSlabRadius = 0.23f, kSlabHeight = 0.015f;

Part teapot(float roughness) {
  Part part{"teapot", {}, {}};
  part.material.name = "copper";
  part.material.baseColor = {0.955f, 0.638f, 0.538f};
  part.material.metallic = 1;
  part.material.roughness = roughness;
  for (const PatchSheet& sheet : teapotSheets()) {
    part.charts.push_back(tessellate(sheet, kMetresPerUnit, vec3(0.0f)));
    if (sheet.name == std::string_view("bottom")) part.charts.back().size *= 0.3f;  // it stands on it
  }
  return part;
}

Part ball(const char* name, Rgb albedo, vec2 groundPoint, float radius, float density) {
  Part part{name, {}, {sphereChart({groundPoint.x, radius, groundPoint.y}, radius, {0, kPi}, 32, 16)}};
  part.material.name = name;
  part.material.baseColor = albedo;
  part.material.specular = 0;
  part.charts[0].size *= density;
  return part;
}

Part slab(float density) {
  Part part{"slab", {}, {}};
  part.material.name = "slab";
  part.material.baseColor = {0.5f, 0.36f, 0.25f};
  part.material.specular = 0;
  Chart top = discChart({0, 0, 0}, kSlabRadius, 80, 4, true);
  Chart side = cylinderChart({0, -kSlabHeight, 0}, kSlabRadius, kSlabHeight, 80);
  Chart underside = discChart({0, -kSlabHeight, 0}, kSlabRadius, 80, 2, false);
  top.size *= density;
  side.size *= vec2(density / 4, density);  // light hardly changes around it
  underside.size *= density / 4;            // hardly ever seen
  part.charts = {top, side, underside};
  return part;
}

}  // namespace

Parameters demoSceneDefaults() {
  return {{"roughness", 0.2}, {"ground_density", 0.4}, {"ball_density", 0.7}};
}

Model makeDemoScene(const Parameters& p) {
  const float balls = float(p.at("ball_density"));
  Model model;
  model.parts = {teapot(float(p.at("roughness"))),
                 ball("red", {0.75f, 0.08f, 0.06f}, {0.07f, 0.135f}, 0.028f, balls),
                 ball("green", {0.1f, 0.5f, 0.14f}, {-0.075f, 0.15f}, 0.02f, balls),
                 ball("blue", {0.08f, 0.16f, 0.65f}, {-0.13f, -0.11f}, 0.032f, balls),
                 slab(float(p.at("ground_density")))};
  return model;
}

}  // namespace boxlight::data
