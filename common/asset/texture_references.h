// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset_format.h"

namespace boxlight::asset {

/// Calls f(name, TextureRef) for each texture that a material may have.
template <class F>
void forEachReference(const Material& m, F&& f) {
  f("baseColorTexture", m.baseColorTexture);
  f("metallicRoughnessTexture", m.metallicRoughnessTexture);
  f("normalTexture", m.normalTexture);
  f("specularTexture", m.specularTexture);
  f("specularColorTexture", m.specularColorTexture);
}

template <class F>
void forEachReference(const MaterialExtension& x, F&& f) {
  f("anisotropyTexture", x.anisotropyTexture);
  f("clearcoatTexture", x.clearcoatTexture);
  f("clearcoatRoughnessTexture", x.clearcoatRoughnessTexture);
  f("clearcoatNormalTexture", x.clearcoatNormalTexture);
  f("sheenColorTexture", x.sheenColorTexture);
  f("sheenRoughnessTexture", x.sheenRoughnessTexture);
  f("transmissionTexture", x.transmissionTexture);
  f("diffuseTransmissionTexture", x.diffuseTransmissionTexture);
  f("diffuseTransmissionColorTexture", x.diffuseTransmissionColorTexture);
  f("iridescenceTexture", x.iridescenceTexture);
  f("iridescenceThicknessTexture", x.iridescenceThicknessTexture);
  f("emissiveTexture", x.emissiveTexture);
}

}  // namespace boxlight::asset
