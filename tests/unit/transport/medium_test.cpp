// SPDX-License-Identifier: Apache-2.0
// Which media a point is in, and what they do to a camera.
#include "bake/transport/medium.h"

#include <gtest/gtest.h>

#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

/// Two boxes of clear media, the second with the corners given.
Scene twoBoxes(vec3 low, vec3 high) {
  Scene scene = test::glass(1.5f);
  test::addBox(scene, vec3(-1), vec3(1));
  scene.materials.push_back(scene.materials[0]);
  scene.materialExtensions.push_back(scene.materialExtensions[0]);
  scene.materialExtensions[1].ior = 1.33f;
  test::addBox(scene, low, high, 1);
  return scene;
}

std::vector<uint32_t> mediaAt(const Scene& scene, dvec3 position) {
  const Intersector world(scene);
  std::vector<uint32_t> common;
  bool first = true;
  for (vec3 direction : {vec3(0, 1, 0), vec3(0.6f, 0, -0.8f), glm::normalize(vec3(-1, -2, 3))}) {
    MediumStack media = enclosingMedia(world, {position, direction});
    std::vector<uint32_t> list;
    while (const auto material = media.innermost()) list.push_back(*material), media.leave(*material);
    if (first) common = list;
    EXPECT_EQ(list, common);
    first = false;
  }
  return common;
}

Rgb seenFromInside(asset::Material material, const asset::MaterialExtension& extension) {
  Scene scene = test::makeScene(material);
  scene.materialExtensions.push_back(extension);
  test::addSphere(scene, vec3(0), 2, 64);
  const Intersector world(scene);
  const Image light = test::environmentOf([](vec3) { return Rgb(1); });
  const Camera camera = makeCamera({.eye = vec3(0), .target = vec3(0, 0, -1), .size = {4, 4}},
                                   scene.boundsMin, scene.boundsMax);
  ReferenceOptions options;
  options.samplesPerPixel = 256;
  const Image picture = renderReference(world, EnvironmentSampler(light, 0), camera, options).mean;
  Rgb mean(0);
  for (uint32_t y = 0; y < 4; ++y)
    for (uint32_t x = 0; x < 4; ++x) mean += rgbAt(picture, x, y) / 16.0f;
  return mean;
}

}  // namespace

TEST(EnclosingMedia, NestedVolumesComeOutermostFirst) {
  const Scene scene = twoBoxes(vec3(-0.5f), vec3(0.5f));
  using Media = std::vector<uint32_t>;  // innermost first
  EXPECT_EQ(mediaAt(scene, {0.01, 0.02, 0.03}), (Media{1, 0}));
  EXPECT_EQ(mediaAt(scene, {0.01, 0.7, 0.03}), (Media{0}));
  EXPECT_EQ(mediaAt(scene, {0.01, 0.02, 1.5}), Media{});
  EXPECT_EQ(mediaAt(scene, {50, 0, 0}), Media{});
}

TEST(EnclosingMedia, OverlappingVolumesBothCount) {
  const Scene scene = twoBoxes({0, -0.9f, -0.9f}, {2, 0.9f, 0.9f});
  for (float up : {-1.0f, 1.0f}) {  // which of the two is the inner one depends on the direction
    MediumStack media = enclosingMedia(Intersector(scene), {dvec3(0.5, 0.02, 0.03), vec3(0, up, 0)});
    media.leave(0);
    EXPECT_EQ(media.innermost(), 1u);
    media.leave(1);
    EXPECT_FALSE(media.innermost());
  }
  EXPECT_EQ(mediaAt(scene, {1.5, 0.02, 0.03}), std::vector<uint32_t>{1});
  EXPECT_EQ(mediaAt(scene, {-0.5, 0.02, 0.03}), std::vector<uint32_t>{0});
}

TEST(EnclosingMedia, OverlappingVolumesAheadAreNotAround) {
  Scene scene = twoBoxes({0, -0.9f, -0.9f}, {2, 0.9f, 0.9f});
  test::addBox(scene, vec3(-9), vec3(-8));  // makes room within the bounds
  EXPECT_FALSE(enclosingMedia(Intersector(scene), {dvec3(-3, 0.02, 0.03), {1, 0, 0}}).innermost());
  EXPECT_FALSE(enclosingMedia(Intersector(scene), {dvec3(-3, 0.02, 0.03), {-1, 0, 0}}).innermost());
}

TEST(MediumStack, RemembersIndicesOfNestedMedia) {
  const Scene scene = twoBoxes(vec3(-0.5f), vec3(0.5f));
  MediumStack media;
  EXPECT_EQ(media.ior(scene), 1.0f);
  media.enter(0), media.enter(1);
  EXPECT_EQ(media.ior(scene), 1.33f);
  EXPECT_EQ(media.iorWithout(scene, 1), 1.5f);
  media.leave(0);  // out of order, as where meshes overlap
  EXPECT_EQ(media.ior(scene), 1.33f);
  media.leave(0);  // never entered
  EXPECT_EQ(media.innermost(), 1u);
  for (int i = 0; i < 100; ++i) media.enter(0);
  for (int i = 0; i < 100; ++i) media.leave(0);
  EXPECT_EQ(media.innermost(), 1u);
}

TEST(CameraInAMedium, SeesThroughWhatAbsorbs) {
  // A matched boundary, seen (double-sided) or culled: the way to it is 2 either way.
  const Scene clear = test::glass(1, {0.1f, 0.5f, 0}, 0);
  for (uint32_t flags : {0u, uint32_t(asset::kDoubleSided)}) {
    asset::Material material = clear.materials[0];
    material.flags |= flags;
    const Rgb seen = seenFromInside(material, clear.materialExtensions[0]);
    EXPECT_NEAR(seen.x, std::exp(-0.2), 2e-3);
    EXPECT_NEAR(seen.y, std::exp(-1.0), 2e-3);
    EXPECT_NEAR(seen.z, 1, 1e-5);
  }
}

TEST(CameraInAMedium, SeesWhiteFogAsTheLight) {
  const Scene fog = test::diffuseMedium(Rgb(0), Rgb(2), 0.5f);
  EXPECT_NEAR(seenFromInside(fog.materials[0], fog.materialExtensions[0]).x, 1, 2e-3);
}
