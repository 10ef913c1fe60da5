// SPDX-License-Identifier: Apache-2.0
// Refraction by known angles and absorption by known lengths.
#include <gtest/gtest.h>

#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

constexpr double kDegree = kPiDouble / 180;

double reflectance(double ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

/// Schlick's, as glTF has it.
double fresnel(double ior, double cosine) {
  return reflectance(ior) + (1 - reflectance(ior)) * std::pow(1 - cosine, 5);
}

/// Mean radiance of the middle of a picture from a far eye in direction `towards`, and its standard error.
test::Estimate lookAt(const Scene& scene, const Image& light, vec3 towards, uint32_t samples) {
  const Intersector world(scene);
  const Camera camera =
      makeCamera({.eye = 100.0f * towards, .target = vec3(0), .fovDegrees = 0.1f, .size = {16, 16}},
                 scene.boundsMin, scene.boundsMax);
  ReferenceOptions options;
  options.samplesPerPixel = samples;
  const ReferencePicture picture = renderReference(world, EnvironmentSampler(light, 0), camera, options);
  test::Estimate estimate;
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 16; ++x) estimate.add(double(rgbAt(picture.mean, x, y).x));
  return estimate;
}

vec3 incoming(double angle) { return {float(std::sin(angle)), -float(std::cos(angle)), 0}; }

double degreesBetween(vec3 a, vec3 b) {
  return std::acos(std::clamp(glm::dot(dvec3(a), dvec3(b)), -1.0, 1.0)) / kDegree;
}

}  // namespace

TEST(Refraction, SlabsTransmitByBeerLambertAndTheSeriesOfInternalReflections) {
  const Image below = test::environmentOf([](vec3 d) { return Rgb(d.y < 0 ? 1.0f : 0.0f); });
  for (double angle : {0.0, 40.0, 65.0})
    for (double absorption : {0.0, 0.5, 2.0}) {
      const Scene scene = test::slab(test::glass(1.5f, Rgb(float(absorption))), 1);
      const double inside = std::asin(std::sin(angle * kDegree) / 1.5);
      const double r = fresnel(1.5, std::cos(angle * kDegree)),
                   passed = std::exp(-absorption / std::cos(inside));
      const double truth = (1 - r) * (1 - r) * passed / (1 - r * r * passed * passed);
      const test::Estimate seen = lookAt(scene, below, -incoming(angle * kDegree), 256);
      EXPECT_NEAR(seen.mean / truth, 1, 0.01) << angle << " degrees, absorption " << absorption;
    }
}

TEST(Refraction, AMatchedSlabOnlyAbsorbs) {
  const Image below = test::environmentOf([](vec3 d) { return Rgb(d.y < 0 ? 1.0f : 0.0f); });
  for (double angle : {0.0, 60.0}) {
    const Scene scene = test::slab(test::glass(1, Rgb(0.7f), 0), 1);
    const test::Estimate seen = lookAt(scene, below, -incoming(angle * kDegree), 4);
    EXPECT_NEAR(seen.mean / std::exp(-0.7 / std::cos(angle * kDegree)), 1, 1e-3) << angle;
  }
}

TEST(Refraction, ASlabShiftsWhatIsSeenThroughIt) {
  const Scene scene = test::slab(test::glass(1.5f), 0.25f);
  const Intersector world(scene);
  for (double angle : {20.0, 45.0, 70.0}) {
    const dvec3 in(incoming(angle * kDegree));
    const double inside = std::asin(std::sin(angle * kDegree) / 1.5);
    const double shift = 0.25 * std::sin(angle * kDegree - inside) / std::cos(inside);
    int straight = 0, close = 0;
    for (uint32_t i = 0; i < 256; ++i) {
      const Ray ray{-3.0 * in, vec3(in)};
      const test::BeamExit exit = test::followBeam(world, ray, {}, Sampler({1, 0, 0}, i));
      if (!exit.escaped || exit.bounces != 2 || exit.direction.y > 0) continue;
      ++straight;
      const dvec3 aside(-in.y, in.x, 0);  // away from the foot of the slab's normal
      // Microfacets of alpha 1e-4 have a long tail.
      close += degreesBetween(exit.direction, vec3(in)) < 0.1 &&
               std::abs(glm::dot(exit.origin, aside) + shift) < 1e-3;
    }
    EXPECT_GT(close, 0.95 * straight);
    EXPECT_GT(straight, 128);
  }
}

TEST(Refraction, AnEdgeBehindASlabMovesBySnellsLaw) {
  // A picture, end to end: an emitting half plane far below, its edge seen with and without the slab.
  const Image dark = test::environmentOf([](vec3) { return Rgb(0); });
  const double angle = 45 * kDegree, inside = std::asin(std::sin(angle) / 1.5);
  const auto lit = [&](bool slab) {
    Scene scene = test::glass(1.5f);
    asset::Material lamp = test::lambert();
    lamp.flags = asset::kUnlit;
    scene.materials.push_back(lamp);
    test::makeExtensions(scene);
    scene.materialExtensions[1] = {};
    if (slab) test::addBox(scene, {-3, 0, -3}, {3, 0.5f, 3});
    test::addQuad(scene, {-9, -0.5f, 9}, {9, 0, 0}, {0, 0, -18}, vec2(0), vec2(1), 1);
    const Intersector world(scene);
    const vec3 towards = -incoming(angle), edge(0, -0.5f, 0);
    const Camera camera =
        makeCamera({.eye = 60.0f * towards + edge, .target = edge, .fovDegrees = 0.6f, .size = {8, 32}},
                   scene.boundsMin, scene.boundsMax);
    ReferenceOptions options;
    options.samplesPerPixel = 256;
    const ReferencePicture picture = renderReference(world, EnvironmentSampler(dark, 0), camera, options);
    double brightest = 0, sum = 0;
    for (uint32_t y = 0; y < 32; ++y) {
      double row = 0;
      for (uint32_t x = 0; x < 8; ++x) row += double(rgbAt(picture.mean, x, y).x) / 8;
      brightest = std::max(brightest, row), sum += row / 32;
    }
    return sum / brightest;
  };
  const double height = 2 * 60 * std::tan(0.3 * kDegree);  // of the picture, in metres at the edge
  const double moved = (lit(true) - lit(false)) * height;
  EXPECT_NEAR(std::abs(moved), 0.5 * std::sin(angle - inside) / std::cos(inside), 0.01);
}

TEST(Refraction, AGlassBallTurnsThePictureUpsideDown) {
  Scene scene = test::glass(1.5f);
  test::addSphere(scene, vec3(0), 1, 256);
  // Behind the ball, -z: red left, green right, blue above.
  const Image light = test::environmentOf(
      [](vec3 d) { return d.z > 0 ? Rgb(0) : Rgb(d.x < 0 ? 1 : 0, d.x > 0 ? 1 : 0, d.y > 0 ? 1 : 0); });
  const Intersector world(scene);
  const Camera camera = makeCamera({.eye = vec3(0, 0, 12), .fovDegrees = 8, .size = {24, 24}},
                                   scene.boundsMin, scene.boundsMax);
  ReferenceOptions options;
  options.samplesPerPixel = 16;
  const Image picture = renderReference(world, EnvironmentSampler(light, 0), camera, options).mean;
  const Rgb left = rgbAt(picture, 8, 12), right = rgbAt(picture, 15, 12), top = rgbAt(picture, 12, 8),
            bottom = rgbAt(picture, 12, 15);
  EXPECT_GT(left.y, 0.8f);
  EXPECT_LT(left.x, 0.1f);
  EXPECT_GT(right.x, 0.8f);
  EXPECT_LT(right.y, 0.1f);
  EXPECT_LT(top.z, 0.1f);
  EXPECT_GT(bottom.z, 0.8f);
}

TEST(Refraction, AGlassBallDeflectsBySnellsLaw) {
  Scene scene = test::glass(1.5f);
  test::addSphere(scene, vec3(0), 1, 512);
  const Intersector world(scene);
  for (double impact : {0.1, 0.3, 0.5, 0.7}) {
    const double deflection = 2 * (std::asin(impact) - std::asin(impact / 1.5));
    int through = 0;
    for (uint32_t i = 0; i < 64; ++i) {
      const Ray ray{dvec3(impact, 0.003, 5), {0, 0, -1}};
      const test::BeamExit exit = test::followBeam(world, ray, {}, Sampler({2, 0, 0}, i));
      if (!exit.escaped || exit.bounces != 2) continue;
      ++through;
      const vec3 truth(-float(std::sin(deflection)), 0, -float(std::cos(deflection)));
      EXPECT_LT(degreesBetween(exit.direction, truth), 0.5) << impact;
    }
    EXPECT_GT(through, 40);
  }
}

TEST(Refraction, WaterInGlassRefractsByRelativeIndices) {
  Scene scene = test::glass(1.5f);
  test::addSphere(scene, vec3(0), 1, 512);
  const size_t outer = scene.triangles.size();
  test::addSphere(scene, vec3(0), 0.5f, 512);
  scene.materials.push_back(scene.materials[0]);
  scene.materialExtensions.push_back(scene.materialExtensions[0]);
  scene.materialExtensions[1].ior = 1.33f;
  for (size_t i = outer; i < scene.triangles.size(); ++i) scene.triangles[i].material = 1;
  const Intersector world(scene);
  for (double impact : {0.1, 0.3, 0.5}) {
    // n r sin(angle) is constant along the path (Bouguer's formula); each surface turns it.
    const double glass = std::asin(impact / 1.5), rim = std::asin(impact / 0.75),
                 water = std::asin(impact / 0.665);
    const double deflection = 2 * (std::asin(impact) - glass + rim - water);
    int through = 0;
    for (uint32_t i = 0; i < 64; ++i) {
      const Ray ray{dvec3(impact, 0.002, 5), {0, 0, -1}};
      const test::BeamExit exit = test::followBeam(world, ray, {}, Sampler({2, 0, 0}, i));
      if (!exit.escaped || exit.bounces != 4) continue;  // in, in, out, out
      ++through;
      const vec3 truth(-float(std::sin(deflection)), 0, -float(std::cos(deflection)));
      EXPECT_LT(degreesBetween(exit.direction, truth), 0.7) << impact;
    }
    EXPECT_GT(through, 40);
  }
}

TEST(Refraction, APrismReflectsTotally) {
  // Legs along x and y, the hypotenuse between (1, 0) and (0, 1): light that enters a leg at a right angle
  // leaves by the other one.
  Scene scene = test::glass(1.5f);
  test::addQuad(scene, {0, 0, 9}, {0, 0, -18}, {1, 0, 0});
  test::addQuad(scene, {0, 0, 9}, {0, 1, 0}, {0, 0, -18});
  test::addQuad(scene, {1, 0, 9}, {0, 0, -18}, {-1, 1, 0});
  const Intersector world(scene);
  const Ray ray{dvec3(0.4, -2, 0.1), {0, 1, 0}};
  test::Estimate turned, returned, other;
  for (uint32_t i = 0; i < 1 << 14; ++i) {
    const test::BeamExit exit = test::followBeam(world, ray, {}, Sampler({5, 0, 0}, i));
    const double weight = exit.escaped ? double(exit.throughput.x) : 0;
    const bool left = exit.direction.x < -0.99f, down = exit.direction.y < -0.99f;
    turned.add(left ? weight : 0), returned.add(down ? weight : 0), other.add(left || down ? 0 : weight);
  }
  const double r = reflectance(1.5);
  EXPECT_LT(std::abs(turned.z((1 - r) * (1 - r) / (1 - r * r))), 4) << turned.mean;
  EXPECT_LT(std::abs(returned.z(r + (1 - r) * (1 - r) * r / (1 - r * r))), 4) << returned.mean;
  EXPECT_EQ(other.mean, 0);
}

TEST(Refraction, ThinWallsLetLightStraightOn) {
  Scene scene = test::glass(1.5f);
  scene.materials[0].flags = 0;
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Intersector world(scene);
  for (double angle : {0.0, 50.0, 75.0}) {
    const dvec3 in(incoming(angle * kDegree));
    test::Estimate passed, close;
    for (uint32_t i = 0; i < 4096; ++i) {
      const test::BeamExit exit =
          test::followBeam(world, {-3.0 * in + dvec3(0.1, 0, 0.2), vec3(in)}, {}, Sampler({5, 0, 0}, i));
      const bool below = exit.escaped && exit.direction.y < 0;
      passed.add(below ? double(exit.throughput.x) : 0);
      if (!below) continue;
      close.add(degreesBetween(exit.direction, vec3(in)) < 0.1);
      EXPECT_NEAR(exit.origin.x, 0.1, 1e-5);
    }
    EXPECT_GT(close.mean, 0.95);
    EXPECT_LT(std::abs(passed.z(1 - fresnel(1.5, std::cos(angle * kDegree)))), 4) << angle;
  }
}
