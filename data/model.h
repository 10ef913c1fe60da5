// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "data/mesh.h"

namespace boxlight::data {

struct Texture {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t>
      rgba;              ///< row 0 at the top, as a PNG stores it: colours are sRGB-encoded, roughness is not
  bool nearest = false;  ///< magnification filter
};

/// What glTF says of a material, as far as these scenes need it.
struct Material {
  std::string name;
  Rgb baseColor{1.0f};  ///< linear
  float alpha = 1;
  float metallic = 0;
  float roughness = 1;  ///< perceptual; GGX alpha is its square
  float specular = 1;   ///< KHR_materials_specular: 0 is a pure Lambert surface
  int baseColorTexture = -1, metallicRoughnessTexture = -1, normalTexture = -1;
  Rgb emissive{0.0f};  ///< linear, [0,1]
  bool doubleSided = false;
  std::string alphaMode = "OPAQUE";                                      ///< or MASK (cutoff .5), BLEND
  nlohmann::ordered_json extensions = nlohmann::ordered_json::object();  ///< glTF's own, by name
  nlohmann::ordered_json textureTransform;  ///< KHR_texture_transform of the three textures; null for none
};

struct Part {
  std::string name;
  Material material;
  std::vector<Chart> charts;
};

/// Once packModel has run, all charts share one atlas. With `textured`, TEXCOORD_0 is Chart::texcoords and
/// the atlas is TEXCOORD_1; without, the atlas is TEXCOORD_0.
struct Model {
  std::vector<Part> parts;
  std::vector<Texture> textures;
  bool textured = false;
};

/// packCharts over all parts.
void packModel(Model& model);

/// A glTF 2.0 binary: one node, mesh and material per part. The same model gives the same bytes. Error:
/// ExitCode::io.
void writeGlb(const std::filesystem::path& path, const Model& model);

}  // namespace boxlight::data
