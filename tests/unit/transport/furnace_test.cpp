// SPDX-License-Identifier: Apache-2.0
// Known answers of the path tracer that need no file: white furnaces and closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/transport/bsdf.h"
#include "bake/transport/reference.h"
#include "bake/transport/reference_integrator.h"
#include "common/light/light_domain.h"
#include "tests/support/bsdf_lab.h"
#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

Image constantLight(Rgb radiance = Rgb(1)) {
  Image image = makeImage(32, 16, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = radiance[int(i % 3)];
  return image;
}

/// Mean radiance over object pixels seen from `eye`.
Rgb meanRadiance(const Scene& scene, const Image& light, vec3 eye, uint32_t spp, vec3 target = vec3(0),
                 float fov = 40) {
  const Intersector world(scene);
  const Camera camera = makeCamera({.eye = eye, .target = target, .fovDegrees = fov, .size = {32, 32}},
                                   scene.boundsMin, scene.boundsMax);
  ReferenceOptions options;
  options.samplesPerPixel = spp;
  options.background = false;
  const ReferencePicture picture = renderReference(world, EnvironmentSampler(light, 0), camera, options);
  dvec3 sum(0);
  double coverage = 0;
  for (uint32_t y = 0; y < 32; ++y)
    for (uint32_t x = 0; x < 32; ++x) {
      sum += dvec3(rgbAt(picture.mean, x, y));
      coverage += double(alphaAt(picture.mean, x, y));
    }
  return Rgb(sum / coverage);
}

}  // namespace

TEST(Furnace, ConvexWhiteLambertReturnsTheLight) {
  Scene scene = test::makeScene(test::lambert());
  test::addSphere(scene, vec3(0), 1, 128);
  const Rgb mean = meanRadiance(scene, constantLight({1, 2, 0.5f}), {0, 0.5f, 4}, 64);
  EXPECT_NEAR(mean.x, 1, 5e-3);
  EXPECT_NEAR(mean.y, 2, 1e-2);
  EXPECT_NEAR(mean.z, 0.5, 2.5e-3);
}

TEST(Furnace, ConcaveWhiteCavityReturnsTheLight) {
  // An open box of albedo 1: every path leaves in the end, whatever the number of bounces.
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, -1, 1}, {2, 0, 0}, {0, 0, -2});
  test::addQuad(scene, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
  test::addQuad(scene, {1, -1, 1}, {-2, 0, 0}, {0, 2, 0});
  test::addQuad(scene, {-1, -1, 1}, {0, 0, -2}, {0, 2, 0});
  test::addQuad(scene, {1, -1, -1}, {0, 0, 2}, {0, 2, 0});
  EXPECT_NEAR(meanRadiance(scene, constantLight(), {0.3f, 5, 0.2f}, 256).x, 1, 5e-3);
}

TEST(Furnace, MetalReturnsItsDirectionalAlbedo) {
  for (float roughness : {0.1f, 0.4f, 1.0f})
    for (float nDotV : {0.2f, 0.6f, 0.98f}) {
      Scene scene = test::makeScene(test::metal(roughness, {0.9f, 0.5f, 0.2f}));
      test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
      // A far eye and a narrow view: n.v is the same in every pixel.
      const vec3 eye = 100.0f * vec3(std::sqrt(1 - nDotV * nDotV), nDotV, 0);
      const Rgb mean = meanRadiance(scene, constantLight(), eye, 256, vec3(0), 0.2f);
      MaterialSample material;
      material.baseColor = {0.9f, 0.5f, 0.2f};
      material.metallic = 1;
      material.roughness = roughness;
      const Bsdf bsdf(material, test::directionAt(nDotV));
      const Rgb albedo = test::sampledAlbedo(bsdf, kSpecular, 512);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(mean[c] / albedo[c], 1, 5e-3) << "roughness " << roughness << ", n.v " << nDotV;
    }
}

TEST(ClosedForm, LambertPlaneUnderAHalfBlackSkyIsHalf) {
  Image light = constantLight();
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 32; ++x)
      if (x < 8 || x >= 24) std::fill(light.at(x, y), light.at(x, y) + 3, 0.0f);  // dark for x < 0
  Scene scene = test::makeScene(test::lambert(Rgb(0.7f)));
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  EXPECT_NEAR(meanRadiance(scene, light, {0, 4, 0.1f}, 256).x, 0.35, 2e-3);
}

TEST(ClosedForm, LambertPlaneBesideAnInfiniteWall) {
  // A black wall at x = 0 over the plane y = 0: the plane at distance d from it sees the configuration factor
  // 1 - F of the sky; for an infinitely tall and long wall F = 1/2 at every distance.
  Scene scene = test::makeScene(test::lambert());
  scene.materials.push_back(test::lambert(Rgb(0)));
  test::addQuad(scene, {1, 0, 0.5f}, {1, 0, 0}, {0, 0, -1});
  test::addQuad(scene, {0, 0, 4000}, {0, 0, -8000}, {0, 4000, 0}, vec2(0), vec2(1), 1);
  EXPECT_NEAR(meanRadiance(scene, constantLight(), {1.5f, 3, 0.01f}, 512, {1.5f, 0, 0}, 10).x, 0.5, 2.5e-3);
}

TEST(ClosedForm, OneTexelSunGivesRhoECosOverPi) {
  Image light = makeImage(128, 64, 3);
  const uint32_t x = 70, y = 20;
  std::fill(light.at(x, y), light.at(x, y) + 3, 1e5f);
  dvec3 irradiance(0);  // of the bilinear texel on the plane y = 0, by quadrature
  constexpr int kSteps = 64;
  for (int j = 0; j < 2 * kSteps; ++j)
    for (int i = 0; i < 2 * kSteps; ++i) {
      const vec2 uv((float(x) - 0.5f + (float(i) + 0.5f) / kSteps) / 128,
                    (float(y) - 0.5f + (float(j) + 0.5f) / kSteps) / 64);
      const vec3 d = uvToDirection(uv);
      const double omega =
          2 * kPiDouble * kPiDouble * std::sqrt(1 - double(d.y) * d.y) / (128.0 * 64 * kSteps * kSteps);
      irradiance += dvec3(sampleEnvironment(light, uv)) * double(d.y) * omega;
    }
  Scene scene = test::makeScene(test::lambert(Rgb(0.5f)));
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Rgb mean = meanRadiance(scene, light, {0, 4, 0.1f}, 64);
  EXPECT_NEAR(mean.x / (0.5 * irradiance.x / kPiDouble), 1, 5e-3);
}

TEST(ClosedForm, AGlowingCavityIsEmissionOverOneMinusAlbedo) {
  asset::Material material = test::lambert(Rgb(0.5f));
  material.flags = asset::kDoubleSided;
  Scene scene = test::makeScene(material);
  test::makeExtensions(scene);
  for (int c = 0; c < 3; ++c) scene.materialExtensions[0].emissive[c] = float(c + 1);
  test::addBox(scene, vec3(-1), vec3(1));
  const Rgb seen = meanRadiance(scene, constantLight(Rgb(0)), {0.2f, 0.1f, 0.3f}, 64);
  const KernelPaths paths = test::lambertPaths(Intersector(scene), 0, true, 1 << 14);
  EXPECT_TRUE(paths.deposits.empty());
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(seen[c] / (2 * float(c + 1)), 1, 5e-3f);
    EXPECT_NEAR(paths.emission()[c] / (2 * float(c + 1)), 1, 5e-3f);
  }
}

TEST(Reference, SameBytesFromTheSameSeed) {
  Scene scene = test::makeScene(test::metal(0.3f));
  test::addSphere(scene, vec3(0), 1, 32);
  const Image light = constantLight();
  EXPECT_EQ(meanRadiance(scene, light, {0, 0, 4}, 4), meanRadiance(scene, light, {0, 0, 4}, 4));
}

TEST(Reference, TheVarianceIsThatOfASampleOverTheirNumber) {
  // Of a plane that looks the same in every pixel; stratification within a pixel is not credited.
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Intersector world(scene);
  const Image light = constantLight();
  const EnvironmentSampler environment(light, 0);
  const Camera camera = makeCamera({.eye = vec3(0, 9, 0.1f), .fovDegrees = 5, .size = {32, 32}},
                                   scene.boundsMin, scene.boundsMax);
  const ReferencePicture one = renderReference(world, environment, camera, {.samplesPerPixel = 1}),
                         many = renderReference(world, environment, camera, {.samplesPerPixel = 16});
  test::Estimate samples, variance;
  for (uint32_t i = 0; i < 32 * 32; ++i) {
    samples.add(double(one.mean.at(i % 32, i / 32)[0]));
    variance.add(double(many.variance.at(i % 32, i / 32)[0]));
  }
  EXPECT_NEAR(16 * variance.mean / (samples.squares / double(samples.count - 1)), 1, 0.2);
}

TEST(Reference, TheLimitOfRadianceSaysWhatItTakes) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Intersector world(scene);
  Image light = constantLight();
  light.at(5, 3)[0] = light.at(5, 3)[1] = light.at(5, 3)[2] = 100;
  const EnvironmentSampler environment(light, 0);
  const Camera camera = makeCamera({.eye = vec3(0, 9, 0.1f), .fovDegrees = 5, .size = {8, 8}},
                                   scene.boundsMin, scene.boundsMax);
  const auto render = [&](float limit) {
    return renderReference(world, environment, camera, {.samplesPerPixel = 64, .radianceLimit = limit});
  };
  const ReferencePicture all = render(std::numeric_limits<float>::infinity()), limited = render(1);
  double sumAll = 0, sumKept = 0;
  for (uint32_t i = 0; i < 64; ++i) {
    sumAll += double(all.mean.at(i % 8, i / 8)[0]);
    sumKept += double(limited.mean.at(i % 8, i / 8)[0]);
  }
  EXPECT_EQ(all.removed, 0);
  EXPECT_GT(limited.removed, 0.01);
  EXPECT_NEAR(limited.removed, 1 - sumKept / sumAll, 1e-5);
}

TEST(Reference, BackFacesAreInvisibleToTheCameraOnly) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Intersector world(scene);
  const Image light = constantLight();
  const EnvironmentSampler environment(light, 0);
  const Camera below = makeCamera({.eye = vec3(0, -4, 0.1f), .target = vec3(0), .size = {8, 8}},
                                  scene.boundsMin, scene.boundsMax);
  ReferenceOptions options;
  options.background = false;
  options.samplesPerPixel = 4;
  EXPECT_EQ(alphaAt(renderReference(world, environment, below, options).mean, 4, 4), 0);
  scene.materials[0].flags |= asset::kDoubleSided;
  EXPECT_EQ(alphaAt(renderReference(world, environment, below, options).mean, 4, 4), 1);
}
