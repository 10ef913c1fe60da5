// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "tests/bench/accuracy/basis.h"

namespace boxlight::accuracy {
namespace {

/// Orthonormal real spherical harmonics about +Y, order l (l + 1) + m, by the usual recurrences of associated
/// Legendre functions.
class Harmonics {
 public:
  explicit Harmonics(uint32_t bands) : bands_(int(bands)), values_(size_t(bands) * bands) {}

  const std::vector<double>& at(dvec3 d) {
    const double sine = std::sqrt(std::max(0.0, 1 - d.y * d.y)), phi = std::atan2(d.z, d.x);
    double diagonal = std::sqrt(1 / (4 * kPiDouble));  // of l = m
    for (int m = 0; m < bands_; ++m) {
      if (m > 0) diagonal *= -std::sqrt((2 * m + 1.0) / (2 * m)) * sine;
      double before = 0, current = diagonal;
      for (int l = m; l < bands_; ++l) {
        set(l, m, current, phi);
        const double a = std::sqrt((4.0 * (l + 1) * (l + 1) - 1) / (double(l + 1) * (l + 1) - m * m));
        const double b = l == m ? 0 : std::sqrt((double(l) * l - m * m) / (4.0 * l * l - 1));
        const double next = a * (d.y * current - b * before);
        before = current;
        current = next;
      }
    }
    return values_;
  }

 private:
  void set(int l, int m, double legendre, double phi) {
    const size_t centre = size_t(l * (l + 1));
    if (m == 0) {
      values_[centre] = legendre;
      return;
    }
    values_[centre + size_t(m)] = std::numbers::sqrt2 * legendre * std::cos(m * phi);
    values_[centre - size_t(m)] = std::numbers::sqrt2 * legendre * std::sin(m * phi);
  }

  int bands_;
  std::vector<double> values_;
};

using Coefficients = std::vector<dvec3>;

Coefficients projectLight(const ProbeLight& light, uint32_t bands) {
  Harmonics harmonics(bands);
  Coefficients sum(size_t(bands) * bands, dvec3(0.0));
  const auto omega = texelSolidAngles(light.map.width, light.map.height);
  for (uint32_t y = 0; y < light.map.height; ++y)
    for (uint32_t x = 0; x < light.map.width; ++x) {
      const vec2 uv = (vec2(x, y) + 0.5f) / vec2(light.map.width, light.map.height);
      const auto& values = harmonics.at(dvec3(uvToDirection(uv)));
      for (size_t i = 0; i < sum.size(); ++i) sum[i] += values[i] * omega[y] * dvec3(rgbAt(light.map, x, y));
    }
  return sum;
}

Coefficients projectKernel(const KernelPaths& paths, uint32_t bands) {
  Harmonics harmonics(bands);
  Coefficients sum(size_t(bands) * bands, dvec3(0.0));
  for (const Deposit& deposit : paths.deposits) {
    const auto& values = harmonics.at(dvec3(uvToDirection(deposit.uv)));
    for (size_t i = 0; i < sum.size(); ++i)
      sum[i] += values[i] * dvec3(deposit.throughput) / double(paths.traced);
  }
  return sum;
}

}  // namespace

Basis harmonicBasis(const std::vector<ProbeLight>& lights, uint32_t bands) {
  auto projected = std::make_shared<std::vector<Coefficients>>();
  for (const ProbeLight& light : lights) projected->push_back(projectLight(light, bands));
  return {"spherical harmonics", bands * bands, bands * bands * 6,
          [projected, bands](const KernelPaths& paths, vec3) {
            const Coefficients kernel = projectKernel(paths, bands);
            Radiances radiance;
            for (const Coefficients& light : *projected) {
              radiance.emplace_back(0.0);
              for (size_t i = 0; i < kernel.size(); ++i) radiance.back() += kernel[i] * light[i];
            }
            return radiance;
          }};
}

}  // namespace boxlight::accuracy
