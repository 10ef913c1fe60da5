// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/light/light_domain.h"
#include "tests/bench/accuracy/basis.h"

namespace boxlight::accuracy {

/// Orthonormal Haar transforms on the six faces of a cube map.
class CubeHaar {
 public:
  static constexpr uint32_t kFace = 128;
  static constexpr uint32_t kTexels = 6 * kFace * kFace;
  using Coefficients = std::vector<vec3>;

  explicit CubeHaar(const std::vector<ProbeLight>& lights) {
    for (const ProbeLight& light : lights) lights_.push_back(transformLight(light));
  }

  /// The `count` coefficients that weigh most, against all lights.
  Radiances relight(const KernelPaths& paths, uint32_t count) const {
    Coefficients flux(kTexels, vec3(0.0f));
    for (const Deposit& deposit : paths.deposits)
      flux[texelOf(uvToDirection(deposit.uv))] += deposit.throughput / float(paths.traced);
    transform(flux);
    std::vector<uint32_t> order(kTexels);
    std::iota(order.begin(), order.end(), 0u);
    const auto importance = [&](uint32_t i) { return glm::length(flux[i]) * supportSide(i); };
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](uint32_t a, uint32_t b) { return importance(a) > importance(b); });
    Radiances radiance(lights_.size(), dvec3(0.0));
    for (size_t l = 0; l < lights_.size(); ++l)
      for (uint32_t k = 0; k < count; ++k) radiance[l] += dvec3(flux[order[k]] * lights_[l][order[k]]);
    return radiance;
  }

 private:
  static uint32_t texelOf(vec3 d) {
    const vec3 a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const uint32_t face = uint32_t(2 * axis + (d[axis] < 0));
    const vec2 at = (vec2(d[(axis + 1) % 3], d[(axis + 2) % 3]) / a[axis] * 0.5f + 0.5f) * float(kFace);
    const uvec2 texel = glm::min(uvec2(at), uvec2(kFace - 1));
    return (face * kFace + texel.y) * kFace + texel.x;
  }

  static vec3 directionAt(uint32_t face, vec2 at) {
    const int axis = int(face / 2);
    vec3 d;
    d[axis] = face % 2 ? -1.0f : 1.0f;
    d[(axis + 1) % 3] = 2 * at.x / kFace - 1;
    d[(axis + 2) % 3] = 2 * at.y / kFace - 1;
    return glm::normalize(d);
  }

  static Coefficients transformLight(const ProbeLight& light) {
    constexpr uint32_t kSamples = 4;  // each way
    Coefficients result(kTexels, vec3(0.0f));
    for (uint32_t face = 0; face < 6; ++face)
      for (uint32_t y = 0; y < kFace * kSamples; ++y)
        for (uint32_t x = 0; x < kFace * kSamples; ++x) {
          const vec2 uv = directionToUv(directionAt(face, (vec2(x, y) + 0.5f) / float(kSamples)));
          const uvec2 texel = glm::min(uvec2(uv * vec2(light.map.width, light.map.height)),
                                       uvec2(light.map.width, light.map.height) - 1u);
          result[(face * kFace + y / kSamples) * kFace + x / kSamples] +=
              rgbAt(light.map, texel.x, texel.y) / float(kSamples * kSamples);
        }
    transform(result);
    return result;
  }

  /// In place; the coefficients of a level stand where its quarter of the face is.
  static void transform(Coefficients& image) {
    Coefficients row(size_t(kFace) * kFace);
    for (uint32_t face = 0; face < 6; ++face)
      for (uint32_t side = kFace; side > 1; side /= 2) {
        const uint32_t half = side / 2;
        vec3* const at = image.data() + size_t(face) * kFace * kFace;
        for (uint32_t y = 0; y < half; ++y)
          for (uint32_t x = 0; x < half; ++x) {
            const vec3 a = at[2 * y * kFace + 2 * x], b = at[2 * y * kFace + 2 * x + 1],
                       c = at[(2 * y + 1) * kFace + 2 * x], d = at[(2 * y + 1) * kFace + 2 * x + 1];
            row[y * side + x] = 0.5f * (a + b + c + d);
            row[y * side + half + x] = 0.5f * (a - b + c - d);
            row[(half + y) * side + x] = 0.5f * (a + b - c - d);
            row[(half + y) * side + half + x] = 0.5f * (a - b - c + d);
          }
        for (uint32_t y = 0; y < side; ++y) std::copy_n(row.begin() + y * side, side, at + size_t(y) * kFace);
      }
  }

  /// In texels.
  static float supportSide(uint32_t index) {
    const uint32_t x = index % kFace, y = index / kFace % kFace;
    uint32_t below = 1;  // the largest power of two that is at most max(x, y)
    while (2 * below <= std::max(x, y)) below *= 2;
    return float(kFace) / float(below);
  }

  std::vector<Coefficients> lights_;
};

std::shared_ptr<const CubeHaar> makeCubeHaar(const std::vector<ProbeLight>& lights) {
  return std::make_shared<const CubeHaar>(lights);
}

Basis waveletBasis(std::shared_ptr<const CubeHaar> haar, uint32_t coefficients) {
  return {
      "Haar wavelets", coefficients, coefficients * 8,
      [haar, coefficients](const KernelPaths& paths, vec3) { return haar->relight(paths, coefficients); }};
}

}  // namespace boxlight::accuracy
