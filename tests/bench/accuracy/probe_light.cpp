// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/probe_light.h"

#include <algorithm>
#include <cmath>

#include "common/light/environment.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "tests/support/kernel_lab.h"

namespace boxlight::accuracy {
namespace {

constexpr double kBlur = 1.5 / 1024;  ///< standard deviation as a part of the width
constexpr double kSunSphere = 0.001, kSunEnergy = 0.25;

std::vector<float> gaussian(double sigma) {
  const int reach = int(std::ceil(3 * sigma));
  std::vector<float> weights;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) sum += std::exp(-i * i / (2 * sigma * sigma));
  for (int i = -reach; i <= reach; ++i)
    weights.push_back(float(std::exp(-i * i / (2 * sigma * sigma)) / sum));
  return weights;
}

/// Along x, periodic, or along y, clamped.
Image blurAlong(const Image& image, const std::vector<float>& weights, bool alongX) {
  Image result = makeImage(image.width, image.height, 3);
  const int reach = int(weights.size() / 2), w = int(image.width), h = int(image.height);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (int i = -reach; i <= reach; ++i) {
        const int sx = alongX ? (x + i + w) % w : x, sy = alongX ? y : std::clamp(y + i, 0, h - 1);
        for (int c = 0; c < 3; ++c)
          result.at(uint32_t(x), uint32_t(y))[c] +=
              weights[size_t(i + reach)] * image.at(uint32_t(sx), uint32_t(sy))[c];
      }
  return result;
}

Image blur(const Image& image) {
  const std::vector<float> weights = gaussian(std::max(kBlur * image.width, 0.3));
  return blurAlong(blurAlong(image, weights, true), weights, false);
}

/// Rows of a random rotation.
std::array<vec3, 3> randomRotation(lab::Random& random) {
  const vec3 a = random.direction();
  vec3 b, c;
  orthonormalBasis(a, b, c);
  const float turn = 2 * kPi * random.uniform();
  return {a, std::cos(turn) * b + std::sin(turn) * c, std::cos(turn) * c - std::sin(turn) * b};
}

Image rotate(const Image& image, const std::array<vec3, 3>& rows, uvec2 size) {
  constexpr uint32_t kSamples = 2;  // each way
  Image map = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < kSamples * size.y; ++y)
    for (uint32_t x = 0; x < kSamples * size.x; ++x) {
      const vec2 uv = (vec2(x, y) + 0.5f) / (float(kSamples) * vec2(size));
      const vec3 d = uvToDirection(uv);
      const vec3 turned(dot(rows[0], d), dot(rows[1], d), dot(rows[2], d));
      const Rgb radiance = sampleEnvironment(image, directionToUv(turned)) / float(kSamples * kSamples);
      for (int c = 0; c < 3; ++c) map.at(x / kSamples, y / kSamples)[c] += radiance[c];
    }
  return map;
}

/// Scales the map to mean 1; the part of the energy in the brightest thousandth of the sphere.
double normalise(Image& map) {
  const std::vector<double> omega = texelSolidAngles(map.width, map.height);
  std::vector<std::pair<double, double>> texels;  // brightness, steradians
  double energy = 0;
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x) {
      const Rgb c = rgbAt(map, x, y);
      texels.emplace_back(double(c.x + c.y + c.z) / 3, omega[y]);
      energy += texels.back().first * omega[y];
    }
  for (float& value : map.pixels) value *= float(4 * kPiDouble / energy);
  std::sort(texels.rbegin(), texels.rend());
  double sphere = 0, bright = 0;
  for (const auto& [value, steradians] : texels) {
    if (sphere > kSunSphere * 4 * kPiDouble) break;
    sphere += steradians;
    bright += value * steradians;
  }
  return bright / energy;
}

}  // namespace

std::vector<ProbeLight> makeProbeLights(const std::vector<std::filesystem::path>& files,
                                        const ProbeOptions& options) {
  std::vector<ProbeLight> lights;
  lab::Random random(4242);
  for (const auto& file : files) {
    const Image image = blur(readEnvironment(file));
    for (uint32_t k = 0; k < options.rotations; ++k) {
      Image map = rotate(image, randomRotation(random), options.size);
      const bool sunLit = normalise(map) > kSunEnergy;
      SummedArea area(map);
      lights.push_back({file.stem().string(), sunLit, std::move(map), std::move(area)});
    }
  }
  return lights;
}

}  // namespace boxlight::accuracy
