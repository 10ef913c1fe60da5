// SPDX-License-Identifier: Apache-2.0
#include "data/scenes.h"

#include <fmt/ranges.h>

#include <cmath>

#include "common/base/error.h"
#include "data/demo_scene.h"
#include "data/gloss_scenes.h"
#include "data/material_scenes.h"
#include "data/textures.h"

namespace boxlight::data {
namespace {

Material lambert(const char* name, Rgb albedo) {
  Material material;
  material.name = name;
  material.baseColor = albedo;
  material.specular = 0;
  return material;
}

Material metal(const Parameters& p) {
  Material material;
  material.name = "metal";
  material.baseColor = Rgb(float(p.at("albedo")));
  material.metallic = 1;
  material.roughness = float(p.at("roughness"));
  return material;
}

Material lambertOrMetal(const Parameters& p) {
  return p.at("metallic") == 0 ? lambert("grey", Rgb(float(p.at("albedo")))) : metal(p);
}

Chart unitSphere() { return sphereChart({0, 0, 0}, 1, {0, kPi}, 96, 48); }

Model onePart(const char* name, Material material, std::vector<Chart> charts) {
  Model model;
  model.parts.push_back({name, std::move(material), std::move(charts)});
  return model;
}

Model makeSphere(const Parameters& p) {
  return onePart("sphere", lambert("white", Rgb(float(p.at("albedo")))), {unitSphere()});
}

Model makeMetalSphere(const Parameters& p) { return onePart("sphere", metal(p), {unitSphere()}); }

Model makeDielectricSphere(const Parameters& p) {
  Material material;
  material.name = "dielectric";
  material.baseColor = Rgb(float(p.at("albedo")));
  material.roughness = float(p.at("roughness"));
  return onePart("sphere", material, {unitSphere()});
}

/// The lower half of a unit sphere, seen from inside and out.
Model makeBowl(const Parameters& p) {
  Material material = lambert("white", Rgb(float(p.at("albedo"))));
  material.doubleSided = true;
  return onePart("bowl", material, {sphereChart({0, 0, 0}, 1, {kPi / 2, kPi}, 96, 24, true)});
}

Chart floorChart(float halfX, float halfZ, uint32_t segments = 1) {
  return rectangleChart({-halfX, 0, halfZ}, {2 * halfX, 0, 0}, {0, 0, -2 * halfZ}, segments);
}

Model makePlane(const Parameters& p) { return onePart("plane", lambertOrMetal(p), {floorChart(1, 1)}); }

/// At x from the wall's foot, a wall of height h without end to both sides hides the fraction (1 - x /
/// sqrt(x^2 + h^2)) / 2 of the cosine-weighted hemisphere: half of it for an endless one.
Model makePlaneWall(const Parameters& p) {
  const float height = float(p.at("height")), width = 4000;
  Chart wall = rectangleChart({0, 0, width / 2}, {0, 0, -width}, {0, height, 0});
  wall.size = vec2(0.1f);  // it is black: a few texels are enough
  Chart strip = rectangleChart({0.01f, 0, 0.05f}, {2, 0, 0}, {0, 0, -0.1f});
  strip.size = {2, 0.5f};
  Model model = onePart("floor", lambert("grey", Rgb(float(p.at("albedo")))), {strip});
  Material black = lambert("black", Rgb(0.0f));
  black.doubleSided = true;
  model.parts.push_back({"wall", black, {wall}});
  return model;
}

Model makeSphereOnGround(const Parameters& p) {
  Model model = onePart("ground", lambert("warm", {0.7f, 0.6f, 0.45f}), {floorChart(3, 3, 4)});
  model.parts.push_back({"sphere", lambertOrMetal(p), {sphereChart({0, 1, 0}, 1, {0, kPi}, 96, 48)}});
  return model;
}

std::vector<Chart> boxCharts(vec3 centre, float half) {
  std::vector<Chart> charts;
  for (int axis = 0; axis < 3; ++axis)
    for (float sign : {-1.0f, 1.0f}) {
      vec3 normal(0.0f), u(0.0f);
      normal[axis] = sign;
      u[(axis + 1) % 3] = 1;
      const vec3 v = glm::cross(normal, u);
      charts.push_back(rectangleChart(centre + half * (normal - u - v), 2 * half * u, 2 * half * v));
    }
  return charts;
}

/// Every face shows the checker twice each way: texture detail far below an atlas texel, and coordinates
/// outside [0,1].
Model makeTexturedBox(const Parameters&) {
  Material material;
  material.name = "painted metal";
  material.metallic = 1;
  material.baseColorTexture = 0;
  material.metallicRoughnessTexture = 1;
  Model model = onePart("box", material, boxCharts({0, 0.75f, 0}, 0.5f));
  for (Chart& chart : model.parts[0].charts)
    for (vec2& uv : chart.texcoords) uv *= 2.0f;
  model.parts.push_back({"ground", lambert("grey", Rgb(0.5f)), {floorChart(2, 2)}});
  model.textures = {checkerTexture(256, 16), roughnessTexture(256)};
  model.textured = true;
  return model;
}

Model makeTexturedQuad(const Parameters&) {
  Material material = lambert("painted", Rgb(1.0f));
  material.baseColorTexture = 0;
  Model model = onePart("quad", material, {floorChart(1, 1)});
  for (vec2& uv : model.parts[0].charts[0].texcoords) uv = uv * 4.0f - 1.0f;
  model.textures = {checkerTexture(256, 16)};
  model.textured = true;
  return model;
}

Model makeMaskedLeaf(const Parameters&) {
  Material material = lambert("leaf", {0.35f, 0.6f, 0.15f});
  material.doubleSided = true;
  material.alphaMode = "MASK";
  material.baseColorTexture = 0;
  Model model =
      onePart("leaf", material, {rectangleChart({-0.8f, 0.5f, 0.7f}, {1.6f, 0, 0}, {0, 0.6f, -1.4f}, 8)});
  model.parts.push_back({"ground", lambert("grey", Rgb(0.7f)), {floorChart(1.5f, 1.5f, 4)}});
  model.textures = {leafTexture(256)};
  model.textured = true;
  return model;
}

}  // namespace

const std::vector<SceneRecipe>& sceneRecipes() {
  static const std::vector<SceneRecipe> recipes = [] {
    std::vector<SceneRecipe> all = {
        {"teapot", "the demo: Newell's teapot in copper, three balls, a ground slab", demoSceneDefaults(),
         makeDemoScene},
        {"sphere", "convex Lambert sphere", {{"albedo", 1}}, makeSphere},
        {"bowl", "open concave Lambert hemisphere, both sides seen", {{"albedo", 1}}, makeBowl},
        {"plane", "2 m square facing +Y", {{"albedo", 1}, {"metallic", 0}, {"roughness", 0.5}}, makePlane},
        {"plane_wall",
         "strip of Lambert floor, x = .01 to 2.01, beside a black wall in x = 0, 4 km long",
         {{"albedo", 1}, {"height", 2000}},
         makePlaneWall},
        {"mirror_sphere",
         "nearly mirroring white metal",
         {{"albedo", 1}, {"roughness", 0.05}},
         makeMetalSphere},
        {"ggx_sphere", "white metal", {{"albedo", 1}, {"roughness", 0.5}}, makeMetalSphere},
        {"glossy_dielectric",
         "dielectric sphere",
         {{"albedo", 0.5}, {"roughness", 0.2}},
         makeDielectricSphere},
        {"sphere_on_ground",
         "a Lambert (metallic 0) or metal sphere standing on Lambert ground",
         {{"albedo", 0.8}, {"metallic", 0}, {"roughness", 0.3}},
         makeSphereOnGround},
        {"textured_box",
         "metal box: checker base colour, roughness gradient, atlas in TEXCOORD_1",
         {},
         makeTexturedBox},
        {"textured_quad",
         "Lambert square with a repeated checker, atlas in TEXCOORD_1",
         {},
         makeTexturedQuad},
        {"masked_leaf", "alpha MASK, double-sided, above Lambert ground", {}, makeMaskedLeaf},
    };
    all.insert(all.end(), glossSceneRecipes().begin(), glossSceneRecipes().end());
    all.insert(all.end(), materialSceneRecipes().begin(), materialSceneRecipes().end());
    return all;
  }();
  return recipes;
}

Model makeScene(const std::string& name, const Parameters& changes) {
  std::vector<std::string> names;
  for (const SceneRecipe& recipe : sceneRecipes()) {
    names.push_back(recipe.name);
    if (recipe.name != name) continue;
    Parameters parameters = recipe.defaults;
    for (const auto& [key, value] : changes) {
      const auto found = parameters.find(key);
      if (found == parameters.end())
        fail(ExitCode::usage, "scene {} has no parameter '{}'; see `boxlight_data list`", name, key);
      found->second = value;
    }
    Model model = recipe.make(parameters);
    packModel(model);
    return model;
  }
  fail(ExitCode::usage, "no scene is called '{}'; there are {}", name, fmt::join(names, ", "));
}

}  // namespace boxlight::data
