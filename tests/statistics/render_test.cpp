// SPDX-License-Identifier: Apache-2.0
// The path tracer against the plainest estimator there is: directions uniform over the sphere, the BSDF's
// value alone, no densities, no light sampling, no weights, no roulette. Pixels are compared by Z-tests, as
// Mitsuba 3 does for its integrators.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/transport/bsdf.h"
#include "bake/transport/reference.h"
#include "common/light/light_domain.h"
#include "tests/support/material_scenes.h"
#include "tests/support/statistics.h"

using namespace boxlight;

namespace {

constexpr uint32_t kSize = 12;
constexpr int kPictures = 16;  ///< what the level is corrected for, at least the number of tests

Image smoothLight() {
  Image image = makeImage(32, 16, 3);
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 32; ++x) {
      const vec3 d = uvToDirection({(float(x) + 0.5f) / 32, (float(y) + 0.5f) / 16});
      image.at(x, y)[0] = 1 + 0.8f * d.x;
      image.at(x, y)[1] = 1 + 0.8f * d.y;
      image.at(x, y)[2] = 0.2f + 2 * std::pow(std::max(0.0f, d.y * 0.8f - d.z * 0.6f), 4.0f);
    }
  return image;
}

vec3 uniformOverTheSphere(vec2 random) {
  const float z = 1 - 2 * random.x, ring = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * kPi * random.y;
  return {ring * std::cos(phi), ring * std::sin(phi), z};
}

struct PlainEstimator {
  const Intersector& world;
  const EnvironmentSampler& environment;
  uint32_t bounces;

  Rgb operator()(SurfacePoint point, vec3 direction, MediumStack media, Sampler& sampler) const {
    Rgb result(0), throughput(1);
    for (uint32_t bounce = 0; bounce < bounces; ++bounce) {
      const SurfaceView surface = viewSurface(world.scene(), point, -direction, media);
      const Bsdf bsdf(surface.material, surface.toLocal(-direction), surface.interface, surface.coatNormal);
      result += throughput * bsdf.emission();
      const vec3 wi = uniformOverTheSphere(sampler.next2());
      throughput *= bsdf.evaluate(wi).value * 4.0f * kPi;
      if (maxComponent(throughput) == 0) return result;
      direction = surface.toWorld(wi);
      if ((glm::dot(direction, surface.geometricNormal) < 0) != (wi.z < 0)) return result;
      if (wi.z < 0 && surface.material.volume) {
        if (surface.back)
          media.leave(surface.materialIndex);
        else
          media.enter(surface.materialIndex);
      }
      float distance;
      const auto next = world.intersect(leaveSurface(world.scene(), surface, direction), distance);
      if (!next) return result + throughput * environment.radiance(direction);
      if (const auto inside = media.innermost())
        for (int c = 0; c < 3; ++c)
          throughput[c] *= std::exp(-world.scene().materialExtensions[*inside].absorption[c] * distance);
      point = *next;
    }
    return result;
  }
};

void expectSamePicture(const Scene& scene, uint32_t bounces, uint32_t spp, uint32_t plainSpp) {
  const Intersector world(scene);
  const Image light = smoothLight();
  const EnvironmentSampler environment(light, 0);
  const Camera camera = makeCamera(
      {.eye = vec3(0.4f, 2.2f, 4), .target = vec3(0, 0.3f, 0), .fovDegrees = 35, .size = {kSize, kSize}},
      scene.boundsMin, scene.boundsMax);
  ReferenceOptions options{.samplesPerPixel = spp, .bounces = bounces, .seed = 1};
  const ReferencePicture truth = renderReference(world, environment, camera, options);
  options = {.samplesPerPixel = plainSpp, .seed = 2};
  const ReferencePicture plain =
      renderPicture(world, environment, camera, options, PlainEstimator{world, environment, bounces});
  const double level = test::sidakLevel(kPictures * 3 * int(kSize * kSize + 1));
  dvec3 difference(0), variance(0);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x)
      for (int c = 0; c < 3; ++c) {
        const double d = double(truth.mean.at(x, y)[c]) - double(plain.mean.at(x, y)[c]);
        const double v = double(truth.variance.at(x, y)[c]) + double(plain.variance.at(x, y)[c]);
        ASSERT_TRUE(std::isfinite(d) && std::isfinite(v));
        difference[c] += d, variance[c] += v;
        EXPECT_GT(test::normalP(d / std::sqrt(v + 1e-10)), level)
            << x << ", " << y << ", channel " << c << ": " << d;
      }
  for (int c = 0; c < 3; ++c)  // the whole picture: a thousandth shows
    EXPECT_GT(test::normalP(difference[c] / std::sqrt(variance[c])), level)
        << "mean, channel " << c << ": z " << difference[c] / std::sqrt(variance[c]);
}

class Renders : public ::testing::TestWithParam<test::SceneMaterial> {};

}  // namespace

TEST_P(Renders, AgreeWithThePlainestEstimator) {
  Scene scene = GetParam().scene();
  scene.materials.push_back(test::lambert({0.6f, 0.6f, 0.6f}));
  scene.materialExtensions.emplace_back();
  test::addQuad(scene, {-0.8f, 0.1f, 0.5f}, {1.6f, 0, 0}, {0, 0.9f, -0.9f});
  test::addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, vec2(0), vec2(1), 1);
  expectSamePicture(scene, 2, 128, 2048);
}

INSTANTIATE_TEST_SUITE_P(Materials, Renders, ::testing::ValuesIn(test::sceneMaterials()),
                         [](const auto& one) { return one.param.name; });

TEST(RenderGlass, RoughBallAgreesWithThePlainestEstimator) {
  test::SceneMaterial glass = test::glassVolume(1);
  glass.extension.absorption[0] = 0.5f;
  Scene scene = glass.scene();
  test::addSphere(scene, {0, 0.3f, 0}, 0.9f, 128);
  expectSamePicture(scene, 2, 256, 16384);
}
