// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/material_terms.h"

#include <algorithm>

#include "common/asset/texture_references.h"

namespace boxlight {
namespace {

using asset::Material;
using asset::MaterialExtension;

bool isBlack(const float (&color)[3]) {
  return std::all_of(std::begin(color), std::end(color), [](float c) { return c == 0.0f; });
}

bool isSpecular(const Material& m) {
  const bool white =
      std::all_of(std::begin(m.specularColor), std::end(m.specularColor), [](float c) { return c == 1.0f; });
  return m.specular != 1.0f || !white || m.specularTexture.texture != asset::kNone ||
         m.specularColorTexture.texture != asset::kNone;
}

template <class Record>
bool isTransformed(const Record& record) {
  bool any = false;
  asset::forEachReference(record, [&](const char*, asset::TextureRef ref) {
    any |= ref.texture != asset::kNone && ref.transform != 0;
  });
  return any;
}

}  // namespace

std::map<std::string, uint32_t> materialTerms(const asset::Asset& asset) {
  std::map<std::string, uint32_t> terms;
  const auto note = [&](const char* name, bool used) {
    if (used) ++terms[name];
  };
  for (size_t i = 0; i < asset.materials.size(); ++i) {
    const Material& m = asset.materials[i];
    const MaterialExtension x =
        asset.materialExtensions.empty() ? MaterialExtension() : asset.materialExtensions[i];
    note("alphaMode MASK", m.flags & asset::kAlphaMask);
    note("alphaMode BLEND", m.flags & asset::kAlphaBlend);
    note("emission", !isBlack(x.emissive));
    note("multiple scattering", m.flags & asset::kMultipleScattering);
    note("scattering", (m.flags & asset::kVolume) && !isBlack(x.scattering));
    note("KHR_materials_anisotropy", x.anisotropy > 0.0f);
    note("KHR_materials_clearcoat", x.clearcoat > 0.0f);
    note("KHR_materials_diffuse_transmission", x.diffuseTransmission > 0.0f);
    note("KHR_materials_ior", x.ior != 1.5f);
    note("KHR_materials_iridescence", x.iridescence > 0.0f);
    note("KHR_materials_sheen", !isBlack(x.sheenColor));
    note("KHR_materials_specular", isSpecular(m));
    note("KHR_materials_transmission", x.transmission > 0.0f);
    note("KHR_materials_unlit", m.flags & asset::kUnlit);
    note("KHR_materials_volume", m.flags & asset::kVolume);
    note("KHR_texture_transform", isTransformed(m) || isTransformed(x));
  }
  return terms;
}

}  // namespace boxlight
