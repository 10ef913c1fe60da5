// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/light/light_domain.h"
#include "tests/bench/accuracy/basis.h"
#include "tests/bench/accuracy/lab_scene.h"
#include "tests/support/kernel_lab.h"

using namespace boxlight;
using namespace boxlight::accuracy;

namespace {

ProbeLight lightOf(const std::function<float(vec3)>& radiance) {
  Image map = makeImage(256, 128, 3);
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x)
      for (int c = 0; c < 3; ++c)
        map.at(x, y)[c] = radiance(uvToDirection((vec2(x, y) + 0.5f) / vec2(map.width, map.height)));
  SummedArea area(map);
  return {"", false, std::move(map), std::move(area)};
}

std::vector<ProbeLight> smoothLights() {
  std::vector<ProbeLight> lights;
  lights.push_back(lightOf([](vec3) { return 1.0f; }));
  lights.push_back(lightOf([](vec3 d) { return 1 + 0.5f * d.x - 0.3f * d.y; }));
  lights.push_back(lightOf([](vec3 d) { return 1 + d.x * d.z + d.y * d.y; }));
  return lights;
}

/// Deposits of a von Mises-Fisher lobe; a twentieth of the paths escape nowhere.
KernelPaths lobe(vec3 axis, float sharpness, uint32_t count) {
  lab::Random random(5);
  vec3 b, c;
  orthonormalBasis(axis, b, c);
  KernelPaths paths;
  for (uint32_t i = 0; i < count; ++i) {
    const float u = random.uniform(), phi = 2 * kPi * random.uniform();
    const float cosine = 1 + std::log(u + (1 - u) * std::exp(-2 * sharpness)) / sharpness;
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    const vec3 d = cosine * axis + sine * (std::cos(phi) * b + std::sin(phi) * c);
    paths.deposits.push_back({directionToUv(glm::normalize(d)), Rgb(0.8f, 0.4f, 0.2f)});
  }
  paths.traced = count + count / 19;
  return paths;
}

constexpr vec3 kNormal(0, 0, 1);

double largestError(const Radiances& a, const Radiances& b) {
  double error = 0;
  for (size_t l = 0; l < a.size(); ++l) error = std::max(error, glm::length(a[l] - b[l]) / glm::length(b[l]));
  return error;
}

}  // namespace

TEST(Accuracy, HarmonicsAreExactForLightsOfTheirBands) {
  const auto lights = smoothLights();
  const KernelPaths paths = lobe(glm::normalize(vec3(1, 2, -1)), 10, 2000);
  const Radiances truth = relightDeposits(paths, lights);
  EXPECT_LT(largestError(harmonicBasis(lights, 3).relight(paths, kNormal), truth),
            3e-3);  // of the maps' texels
  EXPECT_GT(largestError(harmonicBasis(lights, 2).relight(paths, kNormal), truth),
            3e-2);  // x z is of the third band
}

TEST(Accuracy, AllWaveletsAreTheKernel) {
  const auto lights = smoothLights();
  const KernelPaths paths = lobe(glm::normalize(vec3(-1, 0.2f, 0.5f)), 400, 500);
  const auto haar = makeCubeHaar(lights);
  const Radiances truth = relightDeposits(paths, lights);
  EXPECT_LT(largestError(waveletBasis(haar, 6 * 128 * 128).relight(paths, kNormal), truth), 3e-3);
  EXPECT_LT(largestError(waveletBasis(haar, 48).relight(paths, kNormal), truth), 0.1);
  EXPECT_GT(largestError(waveletBasis(haar, 1).relight(paths, kNormal), truth), 0.1);
}

TEST(Accuracy, GaussiansFindALobe) {
  std::vector<ProbeLight> lights = smoothLights();
  const vec3 axis = glm::normalize(vec3(0.3f, 0.8f, 0.6f));
  lights.push_back(lightOf([&](vec3 d) { return dot(d, axis) > 0.98f ? 1.0f : 0.0f; }));
  const float sharpness = 40;
  const KernelPaths paths = lobe(axis, sharpness, 20000);
  const double cap = 0.95 * (1 - std::exp(-sharpness * 0.02)) / (1 - std::exp(-2 * sharpness));
  for (const uint32_t gaussians : {1u, 4u})
    EXPECT_NEAR(gaussianBasis(lights, gaussians).relight(paths, kNormal)[3].x, 0.8 * cap, 0.02) << gaussians;
}

TEST(Accuracy, EnergyIsKeptUnderAConstantLight) {
  const auto lights = smoothLights();
  const KernelPaths paths = lobe({0, 0, 1}, 3, 3000);
  const double energy = 0.8 * 3000.0 / paths.traced;
  for (const Basis& basis : {boxBasis(lights, 4), harmonicBasis(lights, 1), gaussianBasis(lights, 2)})
    EXPECT_NEAR(basis.relight(paths, kNormal)[0].x, energy, 1e-3) << basis.name;
}

TEST(Accuracy, CosineBoxesAreTheLambertKernelInTheOpen) {
  auto lights = smoothLights();
  lights.push_back(
      lightOf([](vec3 d) { return dot(d, glm::normalize(vec3(1, 1, 0.2f))) > 0.999f ? 500.0f : 1.0f; }));
  lab::Random random(5);
  KernelPaths paths;
  for (paths.traced = 0; paths.traced < 40000; ++paths.traced) {
    const float sine = std::sqrt(random.uniform()), phi = 2 * kPi * random.uniform();
    const vec3 d(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - sine * sine));
    paths.first.push_back({d, true});
    paths.deposits.push_back({directionToUv(d), Rgb(1), Rgb(0), true});
  }
  const Radiances truth = relightDeposits(paths, lights);
  EXPECT_LT(largestError(lambertBasis(lights, 1).relight(paths, kNormal), truth), 0.03);
  EXPECT_GT(largestError(boxBasis(lights, 1).relight(paths, kNormal), truth), 0.1);
}

TEST(Accuracy, TheErrorIsFreeOfTheReferencesNoise) {
  // Values of error .1, references with noise as large as that around 1.
  const auto lights = smoothLights();
  RelativeError error(lights.size());
  lab::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    Reference reference;
    for (size_t l = 0; l < lights.size(); ++l) {
      const dvec3 a(0.7 + 0.6 * random.uniform()), b(0.7 + 0.6 * random.uniform());
      reference.mean.push_back((a + b) / 2.0);
      reference.variance.push_back((a - b) * (a - b) / 4.0);
    }
    error.add(Radiances(lights.size(), dvec3(1.1)), reference);
  }
  EXPECT_NEAR(error.mean(lights, false), 0.1, 0.005);
  EXPECT_EQ(error.mean(lights, true), 0.0);
}
