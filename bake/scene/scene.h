// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/asset/asset_format.h"
#include "common/base/math.h"

namespace boxlight {

inline constexpr double kLeastTexelScale = 0.01, kMostTexelScale = 100;

/// How much denser than elsewhere the texels of some triangles are to be, as a user asked.
struct TexelScale {
  uint32_t firstTriangle;  ///< up to the next entry's
  float scale;             ///< of texels per metre
};
static_assert(sizeof(TexelScale) == 8);  // hashed as bytes

/// A glTF scene flattened to world space, in the records that the asset stores: what is baked is what is
/// shipped.
struct Scene {
  std::filesystem::path path;
  std::vector<asset::Vertex> vertices;  ///< world space, metres; atlasUv is set by chooseAtlas (atlas.h)
  std::vector<asset::Triangle> triangles;
  std::vector<asset::Material>
      materials;  ///< at least one: glTF's default material where a primitive has none
  std::vector<asset::MaterialExtension>
      materialExtensions;  ///< one for each material, or empty if no material has any
  std::vector<asset::TextureTransform> textureTransforms;
  std::vector<asset::Texture> textures;
  std::vector<uint32_t> texels;          ///< RGBA8 of all textures, R in the low byte
  std::vector<TexelScale> texelScales;   ///< by rising firstTriangle; 1 before the first
  bool hasTexcoord[2] = {false, false};  ///< does every primitive have TEXCOORD_0 / _1?
  vec3 boundsMin{0.0f}, boundsMax{0.0f};
  uint64_t hash = 0;  ///< xxh64 over everything above that a bake depends on
};

/// Scene::texelScales, per triangle.
std::vector<float> texelScaleOfTriangles(const Scene& scene);

}  // namespace boxlight
