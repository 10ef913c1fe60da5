// SPDX-License-Identifier: Apache-2.0
#include "common/image/tone_map.h"

namespace boxlight {
namespace {

constexpr float kBrightest = 1e6f;  // white in every curve, and its square is a float

float usable(float channel) { return channel > 0.0f ? std::min(channel, kBrightest) : 0.0f; }

float acesCurve(float c) { return c * (2.51f * c + 0.03f) / (c * (2.43f * c + 0.59f) + 0.14f); }

Rgb neutral(Rgb c) {
  constexpr float kReflection = 0.04f;          // of a dielectric at normal incidence
  constexpr float kStart = 0.8f - kReflection;  // where compression starts
  constexpr float kDesaturation = 0.15f;
  const float darkest = std::min(c.x, std::min(c.y, c.z));
  c -= darkest < 2 * kReflection ? darkest - 6.25f * darkest * darkest : kReflection;
  const float peak = maxComponent(c);
  if (peak < kStart) return c;
  constexpr float kRoom = 1.0f - kStart;
  const float compressed = 1.0f - kRoom * kRoom / (peak + kRoom - kStart);
  const float white = 1.0f - 1.0f / (kDesaturation * (peak - compressed) + 1.0f);
  return glm::mix(c * (compressed / peak), Rgb(compressed), white);
}

}  // namespace

Rgb applyToneMap(ToneMap map, Rgb radiance) {
  const Rgb c(usable(radiance.x), usable(radiance.y), usable(radiance.z));
  Rgb display = c;
  if (map == ToneMap::reinhard) display = c / (1.0f + c);
  if (map == ToneMap::aces) display = {acesCurve(c.x), acesCurve(c.y), acesCurve(c.z)};
  if (map == ToneMap::neutral) display = neutral(c);
  return glm::min(display, Rgb(1.0f));
}

}  // namespace boxlight
