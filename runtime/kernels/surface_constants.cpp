// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/surface_constants.h"

#include <algorithm>

#include "common/light/wide_lobe.h"

namespace boxlight::gpu {
namespace {

bool isColored(const asset::Asset& asset) {
  return std::any_of(asset.vertices.begin(), asset.vertices.end(), [](const asset::Vertex& vertex) {
    return vertex.color[0] != 1.0f || vertex.color[1] != 1.0f || vertex.color[2] != 1.0f;
  });
}

bool hasFlag(const asset::Asset& asset, uint32_t flag) {
  return std::any_of(asset.materials.begin(), asset.materials.end(),
                     [&](const asset::Material& material) { return (material.flags & flag) != 0; });
}

template <class Predicate>
bool anyExtension(const asset::Asset& asset, Predicate&& predicate) {
  return std::any_of(asset.materialExtensions.begin(), asset.materialExtensions.end(), predicate);
}

}  // namespace

bool isGlossy(const asset::Asset& asset) {
  return std::any_of(asset.tiles.begin(), asset.tiles.end(),
                     [](const asset::Tile& tile) { return tile.glossyBoxes > 0; });
}

bool hasLambertKernels(const asset::Asset& asset) {
  return std::any_of(asset.tiles.begin(), asset.tiles.end(),
                     [](const asset::Tile& tile) { return tile.diffuseBoxes > 0; });
}

bool isBlended(const asset::Asset& asset) { return hasFlag(asset, asset::kAlphaBlend); }

bool isNormalMapped(const asset::Asset& asset) {
  return std::any_of(asset.materials.begin(), asset.materials.end(), [](const asset::Material& material) {
    return material.normalTexture.texture != asset::kNone;
  });
}

bool hasSheen(const asset::Asset& asset) {
  return anyExtension(asset, [](const asset::MaterialExtension& e) {
    return e.sheenColor[0] > 0.0f || e.sheenColor[1] > 0.0f || e.sheenColor[2] > 0.0f;
  });
}

bool hasSplitLobes(const asset::Asset& asset) { return !asset.visibilityMaps.empty(); }

bool hasDirectionCells(const asset::Asset& asset) { return !asset.cellSphere.empty(); }

SurfaceConstants surfaceConstants(const asset::Asset& asset, uint32_t layers) {
  using Extension = asset::MaterialExtension;
  SurfaceConstants constants{};
  constants[kConstantGlossy] = isGlossy(asset);
  constants[kConstantTextured] = !asset.textures.empty();
  constants[kConstantTransformed] = !asset.textureTransforms.empty();
  constants[kConstantColored] = isColored(asset);
  constants[kConstantMasked] = hasFlag(asset, asset::kAlphaMask);
  constants[kConstantExtended] = !asset.materialExtensions.empty();
  constants[kConstantClearcoat] = anyExtension(asset, [](const Extension& e) { return e.clearcoat > 0.0f; });
  constants[kConstantSheen] = hasSheen(asset);
  constants[kConstantOtherSide] =
      anyExtension(asset, [](const Extension& e) { return e.diffuseTransmission > 0.0f; });
  constants[kConstantFilm] = anyExtension(asset, [](const Extension& e) { return e.iridescence > 0.0f; });
  constants[kConstantLayers] = layers;
  constants[kConstantNormalMapped] = isNormalMapped(asset);
  constants[kConstantSplit] = hasSplitLobes(asset);
  constants[kConstantLambert] = hasLambertKernels(asset);
  constants[kConstantCells] = hasDirectionCells(asset);
  constants[kConstantLevels] = !asset.atlasLevels.empty();
  return constants;
}

}  // namespace boxlight::gpu
