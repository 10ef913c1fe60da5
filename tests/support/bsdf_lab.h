// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "bake/transport/bsdf.h"

namespace boxlight::test {

inline vec3 directionAt(float cosine, float phi = 0.0f) {
  const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// Directional albedo of `lobes` by midpoints over the numbers that sample() takes, steps^2 pairs for each of
/// `choices` choices of the lobe: converges for lobes of any width.
inline Rgb sampledAlbedo(const Bsdf& bsdf, uint32_t lobes, int steps, int choices = 1) {
  dvec3 sum(0.0);
  for (int k = 0; k < choices; ++k)
    for (int i = 0; i < steps * steps; ++i) {
      const vec2 random = (vec2(i % steps, i / steps) + 0.5f) / float(steps);
      const LobeSample drawn = bsdf.sample((float(k) + 0.5f) / float(choices), random, lobes);
      if (drawn.delta) {
        sum += dvec3(drawn.weight);
        continue;
      }
      const LobeValue lobe = bsdf.evaluate(drawn.wi, lobes);
      if (lobe.density > 0.0f) sum += dvec3(lobe.value / lobe.density);
    }
  return Rgb(sum / (double(steps) * steps * choices));
}

}  // namespace boxlight::test
