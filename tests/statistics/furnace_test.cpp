// SPDX-License-Identifier: Apache-2.0
// White furnaces: what each material returns of a constant light, by path tracing and by the bake, against
// its directional albedo by quadrature.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/kernels/texel_bake.h"
#include "bake/transport/bsdf.h"
#include "bake/transport/reference.h"
#include "tests/support/bsdf_lab.h"
#include "tests/support/material_scenes.h"

using namespace boxlight;

namespace {

void addPlane(Scene& scene) { test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}); }

/// Mean over the picture under a light of radiance 1, with the environment behind.
struct Return {
  Rgb mean;
  float tolerance;  ///< five standard deviations of the mean, and the quadrature's own error
};

Return furnace(const Scene& scene, vec3 eye, float fov, uint32_t spp) {
  const Intersector world(scene);
  Image light = makeImage(8, 4, 3);
  std::fill(light.pixels.begin(), light.pixels.end(), 1.0f);
  const Camera camera = makeCamera({.eye = eye, .target = vec3(0), .fovDegrees = fov, .size = {8, 8}},
                                   scene.boundsMin, scene.boundsMax);
  const ReferencePicture picture =
      renderReference(world, EnvironmentSampler(light, 0), camera, {.samplesPerPixel = spp});
  dvec3 sum(0);
  double variance = 0;
  for (uint32_t i = 0; i < 64; ++i) {
    sum += dvec3(rgbAt(picture.mean, i % 8, i / 8)) / 64.0;
    variance += double(maxComponent(rgbAt(picture.variance, i % 8, i / 8))) / (64.0 * 64.0);
  }
  return {Rgb(sum), 5 * float(std::sqrt(variance)) + 2e-3f};
}

/// The BSDF of the plane towards wo, from the side that wo lies on.
struct PlaneBsdf {
  PlaneBsdf(const Scene& scene, vec3 wo)
      : surface(viewSurface(scene, {0, vec2(0.3f)}, wo)),
        bsdf(surface.material, surface.toLocal(wo), surface.interface, surface.coatNormal) {}
  SurfaceView surface;
  Bsdf bsdf;
};

class Furnace : public ::testing::TestWithParam<test::SceneMaterial> {};

void expectReturns(const Return& found, Rgb expected, const std::string& where) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found.mean[c], expected[c], found.tolerance) << where << ", channel " << c;
}

void expectNear(Rgb found, Rgb expected, float tolerance, const std::string& where) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << where << ", channel " << c;
}

}  // namespace

TEST_P(Furnace, APlaneReturnsItsAlbedo) {
  Scene scene = GetParam().scene();
  addPlane(scene);
  for (const float nDotV : {0.2f, 0.6f, 0.98f})
    for (const float side : {1.0f, -1.0f}) {
      const vec3 wo(std::sqrt(1 - nDotV * nDotV), side * nDotV, 0);
      const PlaneBsdf plane(scene, wo);
      const Rgb albedo = test::sampledAlbedo(plane.bsdf, kAllLobes, 16, 512) + plane.bsdf.emission();
      // A far eye and a narrow view: n.v is the same in every pixel.
      expectReturns(furnace(scene, 100.0f * wo, 0.2f, 512), albedo, "n.v " + std::to_string(side * nDotV));
    }
}

TEST_P(Furnace, BakedKernelsTimesThePixelsFactorAreTheAlbedo) {
  Scene scene = GetParam().scene();
  addPlane(scene);
  const Intersector world(scene);
  const TexelMap map = makeTexels(scene, 1, 1);
  const ViewSphere sphere(3);
  const KernelOptions options{.paths = 128, .boxes = 4};
  TexelBaker baker(world, map, sphere, options);
  for (const RecordPlan& plan : planRecords(world, map)) {
    const RecordKernels kernels = baker.bake(plan, options.glossySlots(plan));
    if (plan.lambert) {
      Rgb energy(0);
      for (const PackedBox& box : kernels.lambert.slots) {
        energy += unpackBox(box).energy;
        EXPECT_TRUE(!isCosineBox(box) || unpackCosineBox(box).isWhole()) << "else its amplitude is no energy";
      }
      expectNear(energy, Rgb(1), 5e-3f, "Lambert");
    }
    const PathOrigin origin = plan.origin(world, map);
    dvec3 found(0), expected(0);
    for (uint32_t view = 0; view < kernels.glossy.size(); ++view) {
      if (kernels.glossy[view].slots.empty()) continue;
      const PlaneBsdf plane(scene, raiseAboveHorizon(sphere.directions()[view], origin.normal));
      for (const PackedBox& box : kernels.glossy[view].slots)
        found += dvec3(unpackBox(box).energy * plane.bsdf.viewDependentAlbedo());
      expected += dvec3(test::sampledAlbedo(plane.bsdf, kViewDependent, 16, 128));
    }
    for (int c = 0; c < 3; ++c)
      if (expected[c] > 0) {
        EXPECT_NEAR(found[c] / expected[c], 1, 0.01) << "glossy, channel " << c;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, Furnace, ::testing::ValuesIn(test::sceneMaterials()),
                         [](const auto& one) { return one.param.name; });

TEST(FurnaceVolume, ASmoothGlassBallReturnsTheLight) {
  Scene scene = test::glassVolume(0).scene();
  test::addSphere(scene, vec3(0), 1, 64);
  expectReturns(furnace(scene, {0, 1, 5}, 15, 512), Rgb(1), "smooth");
}

TEST(FurnaceVolume, ARoughGlassBallLosesOnlyWhatMicrofacetsMask) {
  Scene scene = test::glassVolume(0.5f).scene();
  test::addSphere(scene, vec3(0), 1, 64);
  const float mean = furnace(scene, {0, 1, 5}, 15, 512).mean.x;
  EXPECT_LE(mean, 1);
  EXPECT_GE(mean, 0.8f);
}

TEST(FurnaceVolume, AWhiteMediumBehindADiffusingBoundaryLosesNothing) {
  test::SceneMaterial marble{"marble", test::lambert(), {}};
  marble.material.flags = asset::kVolume;
  marble.extension.diffuseTransmission = 1;
  for (float& s : marble.extension.scattering) s = 4;
  Scene scene = marble.scene();
  test::addSphere(scene, vec3(0), 1, 64);
  expectReturns(furnace(scene, {0, 1, 5}, 15, 256), Rgb(1), "marble");
}

TEST(FurnaceBlend, ALayerOfAlphaOneQuarterShowsThreeQuartersOfWhatLiesBehind) {
  asset::Material material = test::lambert(Rgb(0.4f));
  material.flags = asset::kAlphaBlend | asset::kDoubleSided;
  material.baseColor[3] = 0.25f;
  Scene scene = test::makeScene(material);
  addPlane(scene);
  expectReturns(furnace(scene, {0, 100, 1}, 0.2f, 4096), Rgb(0.25f * 0.4f + 0.75f), "blend");
}
