// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>

#include "common/asset/asset_checks.h"
#include "common/asset/number_checks.h"
#include "common/asset/texture_references.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

bool allFractions(std::span<const float> values) {
  return std::all_of(values.begin(), values.end(), isFraction);
}
bool anyBelow(std::span<const float> values, float limit) {
  return std::any_of(values.begin(), values.end(), [limit](float value) { return value < limit; });
}

/// Every number of the record but the texture references behind them.
constexpr size_t kNumbers = offsetof(MaterialExtension, anisotropyTexture) / sizeof(float);

void checkValues(const MaterialExtension& x, const std::string& place, const Reporter& report) {
  const auto bad = [&](FindingCode code, const char* what) {
    report(code, chunk::kMaterialExtensions, place, "{}", what);
  };
  const auto words = std::bit_cast<std::array<float, sizeof x / sizeof(float)>>(x);
  if (!allFinite(std::span(words).first<kNumbers>())) return bad(notFinite, "NaN or infinite");
  if (x.ior < 0.0f || x.iridescenceIor <= 0.0f) bad(extensionValue, "a negative index of refraction");
  if (anyBelow(x.emissive, 0.0f)) bad(extensionValue, "emissive below 0");
  if (anyBelow(x.absorption, 0.0f) || anyBelow(x.scattering, 0.0f))
    bad(extensionValue, "absorption or scattering below 0");
  if (std::abs(x.scatterAnisotropy) >= 1.0f) bad(extensionValue, "scatterAnisotropy outside (-1,1)");
  const std::array fractions = {x.anisotropy,   x.clearcoat,           x.clearcoatRoughness, x.sheenRoughness,
                                x.transmission, x.diffuseTransmission, x.iridescence};
  if (!allFractions(fractions) || !allFractions(x.sheenColor) || !allFractions(x.diffuseTransmissionColor))
    bad(materialValue, "a factor or colour outside [0,1]");
  if ((x.ior > 0.0f && x.ior < 1.0f) || x.iridescenceIor < 1.0f)
    bad(materialValue, "an index of refraction below 1");
  if (anyBelow(x.iridescenceThickness, 0.0f)) bad(materialValue, "iridescenceThickness below 0");
}

void checkReference(const Asset& asset, const ChunkSet& present, uint32_t chunk, const std::string& place,
                    const char* name, TextureRef reference, const Reporter& report) {
  if (reference.texture == kNone) return;
  const bool exists = !present.has({chunk::kTextures}) || reference.texture < asset.textures.size();
  const bool transformed =
      !present.has({chunk::kTextureTransforms}) || reference.transform <= asset.textureTransforms.size();
  if (exists && transformed && reference.texcoord <= 1) return;
  report(materialTexture, chunk, fmt::format("{}, {}", place, name),
         "texture {} of {}, texture coordinate {}, transform {} of {}", reference.texture,
         asset.textures.size(), reference.texcoord, reference.transform, asset.textureTransforms.size());
}

}  // namespace

void checkReferences(const Asset& asset, const ChunkSet& present, const Material& material,
                     const std::string& place, const Reporter& report) {
  forEachReference(material, [&](const char* name, TextureRef reference) {
    checkReference(asset, present, chunk::kMaterials, place, name, reference, report);
  });
}

void checkReferences(const Asset& asset, const ChunkSet& present, const MaterialExtension& extension,
                     const std::string& place, const Reporter& report) {
  forEachReference(extension, [&](const char* name, TextureRef reference) {
    checkReference(asset, present, chunk::kMaterialExtensions, place, name, reference, report);
  });
}

void checkMaterialExtensions(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  const size_t count = asset.materialExtensions.size();
  if (present.has({chunk::kMaterials, chunk::kMaterialExtensions})) {
    if (count != 0 && count != asset.materials.size())
      report(counts, chunk::kMaterialExtensions, "", "{} entries for {} materials", count,
             asset.materials.size());
    for (size_t i = 0; i < asset.materials.size() && count == 0; ++i)
      if (asset.materials[i].flags & kExtensionFlags)
        report(extensionMissing, chunk::kMaterials, fmt::format("material {}", i), "flags {:#x} without MATX",
               asset.materials[i].flags);
  }
  for (size_t i = 0; i < count; ++i) {
    const std::string place = fmt::format("material {}", i);
    checkValues(asset.materialExtensions[i], place, report);
    checkReferences(asset, present, asset.materialExtensions[i], place, report);
  }
  if (asset.textureTransforms.size() > kMaxTextureTransforms)
    report(limits, chunk::kTextureTransforms, "", "{} entries, allowed are {}",
           asset.textureTransforms.size(), kMaxTextureTransforms);
  for (size_t i = 0; i < asset.textureTransforms.size(); ++i)
    if (!allFinite(std::bit_cast<std::array<float, 6>>(asset.textureTransforms[i])))
      report(notFinite, chunk::kTextureTransforms, fmt::format("transform {}", i), "NaN or infinite");
}

}  // namespace boxlight::asset
