// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_scatter.h"

#include <algorithm>
#include <cmath>

namespace boxlight {
namespace {

// A colour of 0 would be an infinite coefficient.
constexpr double kMinAttenuation = 1e-4;
constexpr double kMinDistance = 1e-9;
// Henyey-Greenstein ends at a delta function at 1.
constexpr double kMaxAnisotropy = 0.999;

// What light loses on its way, absorbed or scattered: Beer and Lambert's sigma_t = -ln(color) / distance.
void readAttenuation(const GltfMembers& volume, float (&attenuation)[3]) {
  if (!volume.has("attenuationDistance")) return;  // infinite
  float color[3] = {1, 1, 1};
  volume.numbers("attenuationColor", color, 0.0, 1.0);
  const double distance = volume.number("attenuationDistance", 1.0, kMinDistance, kNoLimit);
  for (int i = 0; i < 3; ++i)
    attenuation[i] = float(std::abs(std::log(std::max(double(color[i]), kMinAttenuation))) / distance);
}

void readScattering(const GltfMembers& scatter, asset::MaterialExtension& x) {
  float color[3] = {0, 0, 0};
  const bool older = !scatter.has("multiscatterColorFactor");
  const bool colored =
      scatter.numbers(older ? "multiscatterColor" : "multiscatterColorFactor", color, 0.0, 1.0);
  x.scatterAnisotropy = scatter.number("scatterAnisotropy", 0.0, -kMaxAnisotropy, kMaxAnisotropy);
  for (int i = 0; i < 3 && colored; ++i) {
    const double attenuation = x.absorption[i];
    const double albedo = singleScatteringAlbedo(color[i], x.scatterAnisotropy);
    x.scattering[i] = float(albedo * attenuation);
    x.absorption[i] = float((1.0 - albedo) * attenuation);
  }
  if (scatter.has("multiscatterColorTexture"))
    scatter.warn("multiscatterColorTexture", "ignored: a medium is the same everywhere");
  scatter.numbers("scattering", x.scattering, 0.0, kNoLimit);
  scatter.numbers("absorption", x.absorption, 0.0, kNoLimit);
}

// What scatters nothing that anyone could see is hardly meant so.
void warnOfNoEffect(const GltfMembers& scatter, const asset::MaterialExtension& x) {
  const auto isZero = [](float coefficient) { return coefficient == 0.0f; };
  if (std::all_of(std::begin(x.scattering), std::end(x.scattering), isZero))
    scatter.warnHere(
        "scatters nothing: the colour is black, or attenuationColor and attenuationDistance leave no "
        "density");
  else if (x.transmission == 0.0f && x.diffuseTransmission == 0.0f)
    scatter.warnHere("has no effect: neither transmission nor diffuse transmission lets light in");
}

}  // namespace

double singleScatteringAlbedo(double c, double g) {
  const double s = 4.09712 + 4.20863 * c - std::sqrt(9.59217 + 41.6808 * c + 17.7126 * c * c);
  return std::clamp((1.0 - s * s) / (1.0 - g * s * s), 0.0, 1.0);
}

bool readMedium(const GltfMembers& material, asset::MaterialExtension& x) {
  const GltfMembers volume = material.extension("KHR_materials_volume");
  const GltfMembers draft = material.extension("KHR_materials_volume_scatter");
  const GltfMembers extras = material.child("extras").child("boxlight_scatter");
  const GltfMembers& scatter = extras ? extras : draft;
  if (volume.number("thicknessFactor", 0.0, 0.0, kNoLimit) == 0.0f) {
    if (scatter) {
      scatter.warnHere("ignored: it needs KHR_materials_volume with a thicknessFactor above 0");
    }
    return false;
  }
  readAttenuation(volume, x.absorption);
  if (scatter) {
    readScattering(scatter, x);
    warnOfNoEffect(scatter, x);
  }
  return true;
}

}  // namespace boxlight
