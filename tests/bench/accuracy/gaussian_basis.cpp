// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "tests/bench/accuracy/basis.h"

namespace boxlight::accuracy {
namespace {

constexpr int kIterations = 60;
constexpr double kMostSharpness = 2e4, kLeastSharpness = 1e-3;

struct Gaussian {
  dvec3 axis{0, 1, 0};
  double sharpness = 1, share = 0;  ///< share of the energy's luminance
  dvec3 energy{0.0};

  /// Integrates to 1 over the sphere.
  double density(dvec3 d) const {
    return sharpness / (2 * kPiDouble * -std::expm1(-2 * sharpness)) *
           std::exp(sharpness * (glm::dot(d, axis) - 1));
  }
};

struct Sample {
  dvec3 direction, energy;
  double weight;
};

std::vector<Sample> samplesOf(const KernelPaths& paths) {
  std::vector<Sample> samples;
  for (const Deposit& deposit : paths.deposits) {
    const dvec3 energy = dvec3(deposit.throughput) / double(paths.traced);
    const double weight = energy.x + energy.y + energy.z;
    if (weight > 0) samples.push_back({dvec3(uvToDirection(deposit.uv)), energy, weight});
  }
  return samples;
}

/// Axes far from each other by farthest-point choice among the samples, weighted by energy.
std::vector<Gaussian> startOf(const std::vector<Sample>& samples, uint32_t count) {
  std::vector<Gaussian> mixture;
  std::vector<double> distance(samples.size(), 4.0);
  for (uint32_t k = 0; k < count; ++k) {
    size_t best = 0;
    for (size_t i = 0; i < samples.size(); ++i)
      if (distance[i] * samples[i].weight > distance[best] * samples[best].weight) best = i;
    mixture.push_back({samples[best].direction, 20, 1.0 / count, dvec3(0.0)});
    for (size_t i = 0; i < samples.size(); ++i) {
      const dvec3 way = samples[i].direction - samples[best].direction;
      distance[i] = std::min(distance[i], glm::dot(way, way));
    }
  }
  return mixture;
}

/// One round of expectation maximisation; sharpness by Banerjee's approximation from the mean vector's
/// length.
void improve(std::vector<Gaussian>& mixture, const std::vector<Sample>& samples) {
  std::vector<dvec3> mean(mixture.size(), dvec3(0.0)), energy = mean;
  std::vector<double> weight(mixture.size(), 0.0), part(mixture.size());
  double all = 0;
  for (const Sample& sample : samples) {
    double total = 0;
    for (size_t k = 0; k < mixture.size(); ++k)
      total += part[k] = mixture[k].share * mixture[k].density(sample.direction);
    for (size_t k = 0; k < mixture.size(); ++k) {
      const double share = total > 0 ? part[k] / total : 1.0 / double(mixture.size());
      weight[k] += share * sample.weight;
      mean[k] += share * sample.weight * sample.direction;
      energy[k] += share * sample.energy;
    }
    all += sample.weight;
  }
  for (size_t k = 0; k < mixture.size(); ++k) {
    Gaussian& gaussian = mixture[k];
    const double length = glm::length(mean[k]);
    gaussian.share = weight[k] / all;
    gaussian.energy = energy[k];
    if (!(length > 0)) continue;
    const double r = std::min(length / weight[k], 1 - 1e-9);
    gaussian.axis = mean[k] / length;
    gaussian.sharpness = std::clamp(r * (3 - r * r) / (1 - r * r), kLeastSharpness, kMostSharpness);
  }
}

Radiances integrate(const std::vector<Gaussian>& mixture, const std::vector<ProbeLight>& lights) {
  const Image& size = lights.front().map;
  const auto omega = texelSolidAngles(size.width, size.height);
  Radiances radiance(lights.size(), dvec3(0.0));
  for (const Gaussian& gaussian : mixture) {
    Radiances sum(lights.size(), dvec3(0.0));
    double norm = 0;  // sharp ones are normalised on the grid that integrates them
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) {
        const vec2 uv = (vec2(x, y) + 0.5f) / vec2(size.width, size.height);
        const double weight = omega[y] * gaussian.density(dvec3(uvToDirection(uv)));
        norm += weight;
        if (weight < 1e-9) continue;
        for (size_t l = 0; l < lights.size(); ++l) sum[l] += weight * dvec3(rgbAt(lights[l].map, x, y));
      }
    for (size_t l = 0; l < lights.size() && norm > 0; ++l) radiance[l] += gaussian.energy * sum[l] / norm;
  }
  return radiance;
}

}  // namespace

Basis gaussianBasis(const std::vector<ProbeLight>& lights, uint32_t gaussians) {
  return {"spherical Gaussians", gaussians, gaussians * 12,
          [&lights, gaussians](const KernelPaths& paths, vec3) {
            const std::vector<Sample> samples = samplesOf(paths);
            if (samples.empty()) return Radiances(lights.size(), dvec3(0.0));
            std::vector<Gaussian> mixture = startOf(samples, gaussians);
            for (int i = 0; i < kIterations; ++i) improve(mixture, samples);
            return integrate(mixture, lights);
          }};
}

}  // namespace boxlight::accuracy
