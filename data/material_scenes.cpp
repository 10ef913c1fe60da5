// SPDX-License-Identifier: Apache-2.0
#include "data/material_scenes.h"

#include <cmath>

#include "data/textures.h"

namespace boxlight::data {
namespace {

constexpr float kRadius = 0.05f;  ///< metres, of the bead
constexpr float kGap = 0.0005f;   ///< to the plate: what touches would leave open which medium lies between
constexpr float kPlateHalf = 0.085f;
constexpr float kPlateDensity = 0.4f;  ///< texels per metre relative to the bead's
constexpr vec3 kCentre{0, kRadius + kGap, 0};
constexpr int kChecker = 0;  ///< texture of every one of these scenes

/// Radius by the angle from +Y: a sphere with a groove of Gaussian section around its shoulder; `slope` is
/// its derivative.
double beadRadius(double theta, double& slope) {
  constexpr double kDepth = 0.22, kWidth = 0.17, kPlace = 1.08;  // of the radius; radians
  const double x = (theta - kPlace) / kWidth, groove = kDepth * std::exp(-x * x);
  slope = kRadius * groove * 2 * x / kWidth;
  return kRadius * (1 - groove);
}

/// The longitude-latitude chart of the whole bead; it is cut on the far side, at -Z. Along u it runs around
/// the axis.
Chart beadChart() {
  const vec2 size(4.0f * kRadius, kPi * kRadius);  // mean ring and meridian of the sphere
  return gridChart(96, 72, size, [](double u, double v, vec3& position, vec3& normal) {
    const double theta = kPiDouble * v, phi = 2 * kPiDouble * ((u == 1.0 ? 0.0 : u) - 0.25);
    double slope;
    const double r = beadRadius(theta, slope);
    const bool pole = v == 0.0 || v == 1.0;
    const double sine = pole ? 0.0 : std::sin(theta), cosine = std::cos(theta);
    auto turned = [&](double ring, double height) {
      return vec3(float(ring * std::cos(phi)), float(height), float(ring * std::sin(phi)));
    };
    position = kCentre + turned(r * sine, r * cosine);
    normal = glm::normalize(turned(pole ? 0.0 : r * sine - slope * cosine, r * cosine + slope * sine));
  });
}

Material named(const char* name, Rgb baseColor, float metallic, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = baseColor;
  material.metallic = metallic;
  material.roughness = roughness;
  return material;
}

Material lambert(const char* name, Rgb albedo) {
  Material material = named(name, albedo, 0, 1);
  material.specular = 0;
  return material;
}

Part plate() {
  Part part{"plate", lambert("plate", Rgb(0.9f)), {}};
  part.material.baseColorTexture = kChecker;
  part.charts = {
      rectangleChart({-kPlateHalf, 0, kPlateHalf}, {2 * kPlateHalf, 0, 0}, {0, 0, -2 * kPlateHalf}, 4)};
  part.charts[0].size *= kPlateDensity;
  return part;
}

Model onPlate(std::vector<Part> parts) {
  Model model;
  model.parts = std::move(parts);
  model.parts.push_back(plate());
  model.textures = {checkerTexture(256, 32)};
  model.textures[kChecker].nearest = false;  // edges as soft as a pixel
  model.textured = true;
  return model;
}

Model bead(const Material& material) { return onPlate({{"bead", material, {beadChart()}}}); }

Model makeDiffuse(const Parameters&) { return bead(lambert("clay", {0.7f, 0.3f, 0.16f})); }

Model makeRoughMetal(const Parameters&) { return bead(named("gold", {1.0f, 0.77f, 0.34f}, 1, 0.5f)); }

Model makeSharpMetal(const Parameters&) { return bead(named("chrome", {0.77f, 0.78f, 0.78f}, 1, 0.15f)); }

/// Highlights spread across the scratches; `rotation` is their direction of spread, from the way around the
/// axis.
Model brushed(double rotation) {
  Material material = named("brushed", {0.91f, 0.92f, 0.92f}, 1, 0.3f);
  material.extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", 0.85},
                                                     {"anisotropyRotation", rotation}};
  return bead(material);
}

Model makeBrushedAlong(const Parameters&) { return brushed(0); }
Model makeBrushedAround(const Parameters&) { return brushed(kPiDouble / 2); }

/// The coat is bumpy, the base under it smooth and rough.
Model makeClearcoat(const Parameters&) {
  Material material = named("paint", {0.5f, 0.02f, 0.03f}, 0, 0.6f);
  material.extensions["KHR_materials_clearcoat"] = {
      {"clearcoatFactor", 1.0},
      {"clearcoatRoughnessFactor", 0.1},
      {"clearcoatNormalTexture", {{"index", 1}, {"scale", 0.35}}}};
  Model model = bead(material);
  model.textures.push_back(bumpTexture(256, {10, 7}));
  return model;
}

Model makeSheen(const Parameters&) {
  Material material = lambert("velvet", {0.1f, 0.02f, 0.16f});
  material.extensions["KHR_materials_sheen"] = {{"sheenColorFactor", {0.9, 0.6, 0.95}},
                                                {"sheenRoughnessFactor", 0.35}};
  return bead(material);
}

Material transmitting(const char* name, Rgb tint, float roughness) {
  Material material = named(name, tint, 0, roughness);
  material.extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1.0}};
  return material;
}

Model makeThinTransmission(const Parameters&) {
  return bead(transmitting("foil", {0.95f, 0.65f, 0.3f}, 0.25f));
}

Material glass(float roughness) {
  Material material = transmitting("glass", Rgb(1.0f), roughness);
  material.extensions["KHR_materials_volume"] = {{"thicknessFactor", double(2 * kRadius)}};
  return material;
}

Model makeSmoothGlass(const Parameters&) { return bead(glass(0)); }
Model makeRoughGlass(const Parameters&) { return bead(glass(0.35f)); }

Model makeColouredVolume(const Parameters&) {
  Material material = glass(0.15f);
  material.extensions["KHR_materials_volume"]["attenuationDistance"] = 0.04;
  material.extensions["KHR_materials_volume"]["attenuationColor"] = {0.1, 0.55, 0.3};
  return bead(material);
}

/// All that enters scatters: `color` is what a thick piece shows, `attenuation` passes one millimetre.
Model scattering(Material material, std::array<double, 3> color, std::array<double, 3> attenuation,
                 double g) {
  material.extensions["KHR_materials_diffuse_transmission"] = {{"diffuseTransmissionFactor", 1.0}};
  material.extensions["KHR_materials_volume"] = {{"thicknessFactor", double(2 * kRadius)},
                                                 {"attenuationDistance", 0.001},
                                                 {"attenuationColor", attenuation}};
  material.extensions["KHR_materials_volume_scatter"] = {{"multiscatterColorFactor", color},
                                                         {"scatterAnisotropy", g}};
  return bead(material);
}

Model makeMarble(const Parameters&) {
  return scattering(named("marble", Rgb(1.0f), 0, 0.3f), {0.93, 0.9, 0.84}, {0.85, 0.84, 0.81}, 0);
}

/// Red light comes out far from where it went in.
Model makeSkin(const Parameters&) {
  return scattering(named("skin", Rgb(1.0f), 0, 0.4f), {0.85, 0.5, 0.36}, {0.9, 0.72, 0.6}, 0.4);
}

/// A thin sheet, bent about its stalk, that hangs between the light behind and the eye.
Model makeLeaf(const Parameters&) {
  Material material = lambert("leaf", {0.35f, 0.6f, 0.15f});
  material.doubleSided = true;
  material.alphaMode = "MASK";
  material.baseColorTexture = 1;
  material.extensions["KHR_materials_diffuse_transmission"] = {
      {"diffuseTransmissionFactor", 0.5}, {"diffuseTransmissionColorFactor", {0.5, 0.75, 0.1}}};
  Chart sheet = gridChart(24, 24, {0.095f, 0.1f}, [](double u, double v, vec3& position, vec3& normal) {
    const double bend = 1.6, radius = 0.095 / bend, angle = (u - 0.5) * bend;  // radians, metres
    const double height = 0.1, tilt = 0.48;                                    // it leans back
    position = {float(radius * std::sin(angle)), float(0.004 + height * v),
                float(radius * (std::cos(angle) - 1) + 0.02 - tilt * height * v)};
    normal =
        glm::normalize(vec3(float(std::sin(angle)), float(tilt * std::cos(angle)), float(std::cos(angle))));
  });
  for (vec2& uv : sheet.texcoords) uv.y = 1 - uv.y;  // images stand upright
  Model model = onPlate({{"leaf", material, {sheet}}});
  model.textures.push_back(leafTexture(256));
  return model;
}

/// Three panes of coloured coverage, one before the other, in front of a white bead.
Model makeBlended(const Parameters&) {
  const Rgb colours[] = {{0.8f, 0.08f, 0.05f}, {0.08f, 0.5f, 0.12f}, {0.06f, 0.15f, 0.75f}};
  std::vector<Part> parts = {{"bead", lambert("white", Rgb(0.8f)), {beadChart()}}};
  for (int i = 0; i < 3; ++i) {
    Material material = lambert("pane", colours[i]);
    material.alpha = 0.5f;
    material.alphaMode = "BLEND";
    material.doubleSided = true;
    const vec3 corner(-0.08f + 0.03f * float(i), 0.006f + 0.013f * float(i), 0.055f + 0.01f * float(i));
    parts.push_back({"pane", material, {rectangleChart(corner, {0.06f, 0, 0}, {0, 0.05f, 0})}});
    parts.back().charts[0].size *= 0.5f;
  }
  return onPlate(std::move(parts));
}

/// A small lamp beside a white bead, which it lights from below.
Model makeEmissive(const Parameters&) {
  Material lamp = lambert("lamp", Rgb(0.2f));
  lamp.emissive = {1.0f, 0.45f, 0.1f};
  lamp.extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", 12.0}};
  Chart sphere = sphereChart({-0.055f, 0.0165f, 0.05f}, 0.016f, {0, kPi}, 32, 16);
  sphere.size *= 0.3f;
  return onPlate({{"bead", lambert("white", Rgb(0.8f)), {beadChart()}}, {"lamp", lamp, {sphere}}});
}

Model makeUnlit(const Parameters&) {
  Material material = named("sign", {1.0f, 0.9f, 0.5f}, 0, 1);
  material.baseColorTexture = kChecker;
  material.extensions["KHR_materials_unlit"] = nlohmann::ordered_json::object();
  return bead(material);
}

Model makeIridescent(const Parameters&) {
  Material material = named("film", Rgb(0.35f), 1, 0.25f);
  material.extensions["KHR_materials_iridescence"] = {
      {"iridescenceFactor", 1.0}, {"iridescenceIor", 1.8}, {"iridescenceThicknessMaximum", 480.0}};
  return bead(material);
}

/// Base colour, bumps and roughness from textures that KHR_texture_transform repeats, turns and shifts.
Model makeTextured(const Parameters&) {
  Material material = named("tiles", Rgb(1.0f), 1, 1);
  material.baseColorTexture = kChecker;
  material.metallicRoughnessTexture = 1;
  material.normalTexture = 2;
  material.textureTransform = {{"offset", {0.1, 0.05}}, {"rotation", 0.3}, {"scale", {3.0, 2.0}}};
  Model model = bead(material);
  model.textures.push_back(roughnessTexture(256));
  model.textures.push_back(bumpTexture(256, {4, 4}));
  return model;
}

}  // namespace

const std::vector<SceneRecipe>& materialSceneRecipes() {
  static const std::vector<SceneRecipe> recipes = {
      {"material_diffuse", "Lambert clay", {}, makeDiffuse},
      {"material_rough_metal", "gold, GGX alpha .25", {}, makeRoughMetal},
      {"material_sharp_metal", "chrome, GGX alpha .0225", {}, makeSharpMetal},
      {"material_brushed_around", "metal brushed around the axis, as on a lathe", {}, makeBrushedAround},
      {"material_brushed_along", "metal brushed from pole to pole", {}, makeBrushedAlong},
      {"material_clearcoat", "bumpy coat over rough red paint", {}, makeClearcoat},
      {"material_sheen", "dark velvet", {}, makeSheen},
      {"material_thin_transmission", "rough tinted foil without inside", {}, makeThinTransmission},
      {"material_smooth_glass", "solid glass, smooth", {}, makeSmoothGlass},
      {"material_rough_glass", "solid glass, GGX alpha .1225", {}, makeRoughGlass},
      {"material_coloured_volume", "solid glass that absorbs", {}, makeColouredVolume},
      {"material_marble", "subsurface scattering, mean free path 6 mm", {}, makeMarble},
      {"material_skin", "subsurface scattering, longest for red", {}, makeSkin},
      {"material_leaf", "thin sheet with diffuse transmission and holes, lit from behind", {}, makeLeaf},
      {"material_blended", "three panes of alpha BLEND before a white bead", {}, makeBlended},
      {"material_emissive", "lamp beside a white bead", {}, makeEmissive},
      {"material_unlit", "KHR_materials_unlit with a texture", {}, makeUnlit},
      {"material_iridescent", "thin film over dark metal", {}, makeIridescent},
      {"material_textured",
       "textures of colour, roughness and bumps under KHR_texture_transform",
       {},
       makeTextured},
  };
  return recipes;
}

}  // namespace boxlight::data
