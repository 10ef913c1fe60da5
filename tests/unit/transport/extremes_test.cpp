// SPDX-License-Identifier: Apache-2.0
// Transport where numbers are hard: docs/testing.md, "Transport extremes".
#include <gtest/gtest.h>

#include "bake/kernels/texel_bake.h"
#include "bake/scene/mesh.h"
#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

bool isFinite(Rgb c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) &&
         std::min(c.x, std::min(c.y, c.z)) >= 0;
}

test::Estimate meanThroughput(const KernelPaths& paths) {
  test::Estimate estimate;
  for (const Deposit& deposit : paths.deposits) {
    EXPECT_TRUE(isFinite(deposit.throughput));
    estimate.add(double(deposit.throughput.x));
  }
  for (size_t i = paths.deposits.size(); i < paths.traced; ++i) estimate.add(0);
  return estimate;
}

/// A hollow sphere, white or grey, without its first `rings` rings of triangles: a hole at the pole.
Scene hollow(float albedo, uint32_t segments, uint32_t rings) {
  Scene scene = test::makeScene(test::lambert(Rgb(albedo)));
  test::addSphere(scene, vec3(0), 1, segments, true);
  const uint32_t gone = rings == 0 ? 0 : segments * (2 * rings - 1);
  if (gone)
    std::erase_if(scene.triangles, [&](const asset::Triangle& t) {
      const auto row = [&](uint32_t v) { return v / (segments + 1); };
      return std::max(row(t.vertex[0]), std::max(row(t.vertex[1]), row(t.vertex[2]))) <= rings;
    });
  return scene;
}

/// The part of the sphere that the hole takes: where each diffuse bounce inside a sphere leaves with the same
/// chance.
double holeOf(uint32_t segments, uint32_t rings) {
  return (1 - std::cos(2 * kPiDouble * rings / segments)) / 2;
}

uint32_t middleOf(const Scene& scene) { return uint32_t(scene.triangles.size() / 2); }

/// Something of everything, of size 2 around the origin: glass, fog, metal and a plane.
Scene assortment(float scale) {
  Scene scene = test::glass(1.5f, Rgb(0.3f, 0.1f, 0) / scale);
  const Scene fog = test::diffuseMedium(Rgb(0.01f) / scale, Rgb(8, 4, 2) / scale, 0.4f);
  scene.materials.push_back(fog.materials[0]);
  scene.materials.push_back(test::metal(0.3f, {0.9f, 0.6f, 0.4f}));
  scene.materials.push_back(test::lambert(Rgb(0.7f)));
  scene.materialExtensions.push_back(fog.materialExtensions[0]);
  test::makeExtensions(scene);
  const auto box = [&](vec3 low, uint32_t material) {
    test::addBox(scene, scale * low, scale * (low + vec3(0.75f)), material);
  };
  test::addQuad(scene, scale * vec3(-1, 0, 1), scale * vec3(2, 0, 0), scale * vec3(0, 0, -2), vec2(0),
                vec2(1), 3);
  box({-1, 0.125f, 0}, 0), box({0.25f, 0.125f, 0}, 1), box({-0.375f, 0.125f, -1}, 2);
  return scene;
}

std::vector<Deposit> depositsOf(float scale, uint32_t count) {
  const Scene scene = assortment(scale);
  return test::lambertPaths(Intersector(scene), 0, false, count).deposits;
}

dvec3 sum(const std::vector<Deposit>& deposits) {
  dvec3 total(0);
  for (const Deposit& deposit : deposits) total += dvec3(deposit.throughput);
  return total;
}

void move(Scene& scene, vec3 by) {
  for (asset::Vertex& v : scene.vertices)
    for (int c = 0; c < 3; ++c) v.position[c] += by[c];
  test::finish(scene);
}

}  // namespace

TEST(Extremes, AWhiteCavityReturnsAllByASmallHole) {
  const Scene scene = hollow(1, 128, 2);
  const Intersector world(scene);
  const test::Estimate mean = meanThroughput(test::lambertPaths(world, middleOf(scene), false, 1 << 14));
  EXPECT_LT(std::abs(mean.z(1)), 4) << mean.mean;
  EXPECT_LT(mean.error(), 0.04);  // hole 1 in 400: a fixed survival of .95 has no variance to speak of
}

TEST(Extremes, AClosedCavityLetsNothingOutAndEnds) {
  for (vec3 far : {vec3(0), vec3(1e5f, -1e5f, 3e4f)}) {
    Scene scene = hollow(1, 64, 0);
    move(scene, far);
    const KernelPaths paths = test::lambertPaths(Intersector(scene), middleOf(scene), false, 2048);
    EXPECT_EQ(paths.traced, 2048u);
    EXPECT_EQ(paths.deposits.size(), 0u) << "far " << far.x;
  }
}

TEST(Extremes, AKeyholeIsUnbiasedOverSeeds) {
  // The sphere's integral equation has constant solutions: every bounce leaves with probability f.
  constexpr uint32_t kSegments = 314;  // f = 1.0e-4
  const double f = holeOf(kSegments, 1), albedo = 0.9;
  const Scene scene = hollow(float(albedo), kSegments, 1);
  const Intersector world(scene);
  const double truth = f / (1 - albedo * (1 - f));
  test::Estimate seeds;
  for (uint64_t seed = 0; seed < 16; ++seed)
    seeds.add(meanThroughput(test::lambertPaths(world, middleOf(scene), false, 1 << 15, seed)).mean / truth);
  EXPECT_LT(std::abs(seeds.z(1)), 4) << seeds.mean;
  EXPECT_LT(seeds.error(), 0.07);
}

TEST(Extremes, ABakeOfAKeyholeKeepsItsEnergy) {
  Scene scene = hollow(0.9f, 314, 1);
  TexelMap map = makeTexels(scene, 8, 8);
  const Intersector world(scene);
  const ViewSphere sphere(3);
  TexelBaker baker(world, map, sphere, {.paths = 512, .boxes = 4});
  RecordPlan plan{.texel = 27};
  plan.record.normal[1] = 1;
  plan.lambert = true;
  Rgb energy(0);
  for (const PackedBox& box : baker.bake(plan, 0).lambert.slots) energy += unpackBox(box).energy;
  const double f = holeOf(314, 1), truth = f / (1 - 0.9 * (1 - f));
  EXPECT_TRUE(isFinite(energy));
  EXPECT_NEAR(double(energy.x) / truth, 1, 0.9);  // 32768 paths: a standard error of .28 at most
  EXPECT_GT(energy.x, 0);
}

TEST(Extremes, PowersOfTwoInScaleChangeNothingAtAll) {
  const std::vector<Deposit> one = depositsOf(1, 4096);
  for (float scale : {0x1p-13f, 0x1p20f}) {
    const std::vector<Deposit> scaled = depositsOf(scale, 4096);
    ASSERT_EQ(scaled.size(), one.size()) << scale;
    EXPECT_TRUE(scaled == one) << scale;
  }
}

TEST(Extremes, OtherScalesChangeRoundingOnly) {
  const std::vector<Deposit> one = depositsOf(1, 4096);
  for (float scale : {1e-4f, 1e6f}) {
    const std::vector<Deposit> scaled = depositsOf(scale, 4096);
    EXPECT_NEAR(sum(scaled).x / sum(one).x, 1, 2e-3) << scale;
    EXPECT_NEAR(double(scaled.size()), double(one.size()), 4) << scale;
  }
}

TEST(Extremes, FarFromTheOriginTheQuantisedSceneIsTracedExactly) {
  // At 2^17 floats are 2^-6 apart; the assortment's corners are multiples of 2^-3 and stay what they are.
  const std::vector<Deposit> near = depositsOf(1, 4096);
  Scene scene = assortment(1);
  move(scene, vec3(0x1p17f, -0x1p17f, 0x1p16f));
  const KernelPaths paths = test::lambertPaths(Intersector(scene), 0, false, 4096);
  EXPECT_NEAR(double(paths.deposits.size()), double(near.size()), 4);
  EXPECT_NEAR(sum(paths.deposits).x / sum(near).x, 1, 2e-3);
}

TEST(Extremes, ExtremeMediaLoseNothing) {
  struct Case {
    float depth, g;
    uint32_t paths;
  };
  for (const Case& c : {Case{1e4f, 0, 4096}, {1e-6f, 0, 4096}, {50, 0.99f, 4096}, {50, -0.99f, 4096}}) {
    Scene scene = test::diffuseMedium(Rgb(0), Rgb(c.depth / 2), c.g);
    test::addSphere(scene, vec3(0), 1, 48);
    const Intersector world(scene);
    const test::Estimate mean = meanThroughput(test::lambertPaths(world, middleOf(scene), true, c.paths));
    EXPECT_NEAR(mean.mean, 1, 0.01) << c.depth << ", g " << c.g;
  }
}

TEST(Extremes, DenseMediaDoNotLeakThroughTheirBoundary) {
  // Places of scattering are rounded; within a mean free path of 2e-5 that would put some behind the surface.
  Scene scene = test::diffuseMedium(Rgb(0), Rgb(5e4f));
  test::addSphere(scene, vec3(0), 1, 48);
  const Intersector world(scene);
  int leaked = 0, arrived = 0;
  for (uint32_t i = 0; i < 1 << 14; ++i) {
    Sampler sampler({4, 0, 0}, i);
    const SurfacePoint start{uint32_t(sampler.next() * float(scene.triangles.size())), {0.3f, 0.3f}};
    const vec3 inward = -surfaceFrame(scene, start).geometricNormal;
    Ray ray{offsetOrigin(scene, start, inward), inward};
    MediumStack media;
    media.enter(0);
    Rgb throughput(1);
    const Travel end = travel(world, media, ray, throughput, sampler);
    const bool outside =
        end.point ? glm::dot(surfaceFrame(scene, *end.point).geometricNormal, ray.direction) < 0 : true;
    if (end.point) ++arrived;
    if (outside && maxComponent(throughput) > 0) ++leaked;
  }
  EXPECT_GT(arrived, 15000);
  EXPECT_LE(leaked, 4);
}

TEST(Extremes, AThickAbsorbingMediumIsAHalfSpace) {
  // Spherical albedo at single scattering albedo .9 (subsurface_test.cpp), mean free path 1e-4 of the body.
  Scene scene = test::diffuseMedium(Rgb(500), Rgb(4500));
  test::addSphere(scene, vec3(0), 1, 48);
  const test::Estimate mean =
      meanThroughput(test::lambertPaths(Intersector(scene), middleOf(scene), true, 1 << 14));
  EXPECT_NEAR(mean.mean, 0.4776, 4 * mean.error() + 1e-3);
}

TEST(Extremes, CoincidentSurfacesHaveOneDeterministicWinner) {
  for (bool sameMaterial : {true, false}) {
    Scene scene = test::makeScene(test::lambert(Rgb(1)));
    scene.materials.push_back(test::lambert(Rgb(0.25f)));
    test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, vec2(0), vec2(1), sameMaterial ? 0 : 1);
    const Intersector world(scene), again(scene);
    std::array<int, 4> hits{};
    for (uint32_t i = 0; i < 4096; ++i) {
      Sampler sampler({9, 0, 0}, i);
      const vec2 xz = sampler.next2() * 1.9f - 0.95f, to = sampler.next2() - 0.5f;
      const Ray ray{dvec3(double(xz.x), 0, double(xz.y)) - 2.0 * dvec3(double(to.x), -1, double(to.y)),
                    glm::normalize(vec3(to.x, -1, to.y))};
      const auto point = world.intersect(ray), same = again.intersect(ray);
      ASSERT_TRUE(point && same);
      EXPECT_EQ(point->triangle, same->triangle);
      ++hits[point->triangle];
    }
    EXPECT_EQ(hits[2] + hits[3], 0);  // the first one wins
    // No path that starts on either is stopped by the other.
    for (uint32_t triangle : {0u, 2u})
      EXPECT_EQ(test::lambertPaths(world, triangle, false, 1024).deposits.size(), 1024u);
  }
}

TEST(Extremes, AnOpenMeshThatClaimsToBeAVolumeEndsAtTheScene) {
  for (bool fog : {false, true}) {
    Scene scene = fog ? test::diffuseMedium(Rgb(0), Rgb(3)) : test::glass(1.5f, Rgb(2));
    test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    const Intersector world(scene);
    EXPECT_FALSE(enclosingMedia(world, {dvec3(0, -5, 0), {0, 1, 0}}).innermost());
    const test::Estimate mean = meanThroughput(test::lambertPaths(world, 0, true, 4096));
    EXPECT_NEAR(mean.mean, 1, 0.02) << fog;
    const Image light = test::environmentOf([](vec3) { return Rgb(1); });
    const Camera camera = makeCamera({.eye = vec3(0, 3, 0.1f), .target = vec3(0), .size = {8, 8}},
                                     scene.boundsMin, scene.boundsMax);
    ReferenceOptions options;
    options.samplesPerPixel = 256;
    const Image picture = renderReference(world, EnvironmentSampler(light, 0), camera, options).mean;
    EXPECT_NEAR(rgbAt(picture, 4, 4).x, 1, 0.03) << fog;
  }
}

/// What an open medium absorbs did not arrive straight: its tint is the deposits' to keep.
TEST(Extremes, LightThroughAnOpenMediumIsNotStraight) {
  Scene scene = test::glass(1.5f, Rgb(2));
  scene.materials.push_back(test::lambert(Rgb(0)));
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  test::addQuad(scene, {90, -1, 1}, {1, 0, 0}, {0, 0, -2}, vec2(0), vec2(1), 1);  // how deep the medium is
  const Intersector world(scene);
  const KernelPaths paths = test::lambertPaths(world, 0, true, 256);
  ASSERT_GT(paths.deposits.size(), 200u);
  for (const Deposit& deposit : paths.deposits) {
    EXPECT_LT(deposit.throughput.x, 0.2f);
    EXPECT_FALSE(deposit.straight);
  }
  for (const FirstDirection& first : paths.first) EXPECT_FALSE(first.straight);
}

TEST(Extremes, MirroredInstancesOfVolumesAreNotInsideOut) {
  Scene scene = test::diffuseMedium({1, 2, 0}, Rgb(0));
  test::addBox(scene, {1, -1, -1}, {3, 1, 1});
  Mesh mesh{.vertices = scene.vertices};
  for (const asset::Triangle& t : scene.triangles)
    mesh.triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  glm::dmat4 mirror(1);
  mirror[0][0] = -1;
  placeMesh(mesh, mirror);
  scene.vertices = mesh.vertices;
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) scene.triangles[i].vertex[k] = mesh.triangles[i][k];
  test::finish(scene);
  const Intersector world(scene);
  EXPECT_TRUE(enclosingMedia(world, {dvec3(-2, 0.1, 0.2), {0, 1, 0}}).innermost());
  EXPECT_FALSE(enclosingMedia(world, {dvec3(0, 0.1, 0.2), {-1, 0, 0}}).innermost());
  const test::BeamExit exit =
      test::followBeam(world, {dvec3(-2.1, 5, 0.3), {0, -1, 0}}, {}, Sampler({1, 0, 0}, 0));
  EXPECT_NEAR(exit.throughput.z, 1, 1e-6);
  EXPECT_LT(exit.throughput.x, 0.5f);
}

TEST(Extremes, HugeThroughputsStayFinite) {
  Scene scene = test::glass(1.5f);
  scene.materials[0].roughness = 0.7f;
  for (float& c : scene.materials[0].specularColor) c = 50;
  asset::Material lamp = test::lambert();
  scene.materials.push_back(lamp);
  test::makeExtensions(scene);
  for (float& c : scene.materialExtensions[1].emissive) c = 1e6f;
  for (int i = 0; i < 8; ++i) {  // plates on edge, met at grazing angles
    const float x = -0.9f + 0.2f * float(i);
    test::addBox(scene, {x, 0, -1}, {x + 0.1f, 1, 1});
  }
  test::addQuad(scene, {-1, -0.01f, 1}, {2, 0, 0}, {0, 0, -2}, vec2(0), vec2(1), 1);
  const Intersector world(scene);
  const KernelPaths paths = test::lambertPaths(world, uint32_t(scene.triangles.size() - 2), false, 1 << 14);
  const test::Estimate mean = meanThroughput(paths);
  EXPECT_TRUE(isFinite(paths.emission()));
  EXPECT_LT(mean.mean, 1 + 4 * mean.error());
  EXPECT_GT(paths.emission().x, 1e4f);
  EXPECT_LT(paths.emission().x, 2e6f);
}

TEST(Extremes, TrianglesWithoutAreaAreNotThere) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  test::addQuad(scene, {-1, 0.5f, 0}, {2, 0, 0}, {1, 0, 0});
  const Intersector world(scene);
  EXPECT_EQ(world.intersect({dvec3(0, 2, 0), {0, -1, 0}})->triangle / 2, 0u);
  EXPECT_EQ(meanThroughput(test::lambertPaths(world, 0, false, 1024)).mean, 1);
}
