// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/paths.h"

#include <gtest/gtest.h>

#include "bake/kernels/scene_bake.h"
#include "common/light/light_domain.h"
#include "tests/support/path_lab.h"

using namespace boxlight;

namespace {

/// A unit quad facing +Y in one texel, with whatever else the scene has.
struct OneTexel {
  explicit OneTexel(const asset::Material& material) : scene(test::makeScene(material)) {
    test::addQuad(scene, {0, 0, 0.5f}, {1, 0, 0}, {0, 0, -1});
  }
  PathOrigin origin(bool back = false) {
    if (map.texels.empty()) map = makeTexels(scene, 1, 1);
    return {map.footprint(map.texels[0]), back, vec3(0, back ? -1 : 1, 0)};
  }
  Scene scene;
  TexelMap map;
};

Rgb meanThroughput(const KernelPaths& paths) {
  dvec3 sum(0);
  for (const Deposit& d : paths.deposits) sum += dvec3(d.throughput);
  return Rgb(sum / double(paths.traced));
}

}  // namespace

TEST(Paths, AnOpenLambertTexelHasACosineKernelOfEnergyOne) {
  OneTexel texel(test::lambert(Rgb(0.2f)));
  const PathOrigin origin = texel.origin();
  const Intersector world(texel.scene);
  KernelPaths paths;
  PathTracer(world, {}).traceLambert(origin, {1, 0, 0}, 4096, paths);
  EXPECT_EQ(paths.traced, 4096u);
  EXPECT_EQ(meanThroughput(paths), Rgb(1));  // without its albedo
  double cosine = 0;
  for (const Deposit& d : paths.deposits) cosine += double(uvToDirection(d.uv).y) / 4096;
  EXPECT_NEAR(cosine, 2.0 / 3.0, 1e-3);
}

TEST(Paths, GlossyKernelsAreDividedByTheirAlbedo) {
  for (float roughness : {0.1f, 0.5f, 1.0f}) {
    OneTexel texel(test::metal(roughness, {0.9f, 0.5f, 0.2f}));
    const PathOrigin origin = texel.origin();
    const Intersector world(texel.scene);
    for (float cosine : {0.05f, 0.4f, 0.95f}) {
      KernelPaths paths;
      const vec3 wo(std::sqrt(1 - cosine * cosine), cosine, 0);
      PathTracer(world, {}).traceGlossy(origin, wo, {1, 0, 0}, 4096, paths);
      const Rgb mean = meanThroughput(paths);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(mean[c], 1, 1e-2) << "roughness " << roughness << ", cosine " << cosine;
    }
  }
}

/// A film over nothing may reflect one channel where the kernels' factor has none of it.
TEST(Paths, GlossyKernelsOfFilmsFitHalfFloats) {
  OneTexel texel(test::lambert(Rgb(0.5f)));
  texel.scene.materials[0].specular = 0, texel.scene.materials[0].roughness = 0.25f;
  test::makeExtensions(texel.scene);
  asset::MaterialExtension& film = texel.scene.materialExtensions[0];
  film.iridescence = 1, film.iridescenceIor = 1.3f, film.iridescenceThickness[1] = 300;
  const PathOrigin origin = texel.origin();
  const Intersector world(texel.scene);
  float largest = 0;
  for (float cosine = 0.1f; cosine < 1; cosine += 0.02f) {
    KernelPaths paths;
    const vec3 wo(std::sqrt(1 - cosine * cosine), cosine, 0);
    PathTracer(world, {}).traceGlossy(origin, wo, {1, 0, 0}, 256, paths);
    if (paths.traced > 0) largest = std::max(largest, maxComponent(meanThroughput(paths)));
  }
  EXPECT_GT(largest, 100.0f);
  EXPECT_LT(largest, 65504.0f);
}

TEST(Paths, WhatIsNotMirroredStraightIsTheHiddenPart) {
  OneTexel texel(test::metal(0.4f));
  test::makeExtensions(texel.scene);
  asset::MaterialExtension& velvet = texel.scene.materialExtensions[0];
  std::fill_n(velvet.sheenColor, 3, 0.5f);
  velvet.sheenRoughness = 0.3f;
  test::addQuad(texel.scene, {-1, 0, 4000}, {0, 0, -8000}, {0, 4000, 0}, vec2(2), vec2(3));  // a wall
  texel.map = makeTexels(texel.scene, 1, 1);
  texel.map.texels[0].pieceCount = 2;  // the quad's own pieces
  const Intersector world(texel.scene);
  KernelPaths paths;
  PathTracer(world, {}).traceGlossy(texel.origin(), glm::normalize(vec3(0.1f, 1, 0)), {1, 0, 0}, 4096, paths);
  double mirrored = 0;
  for (const Deposit& d : paths.deposits) mirrored += double(luminance(d.mirrored)) / paths.traced;
  const double all = double(luminance(meanThroughput(paths)));
  EXPECT_GT(mirrored, 0.1);
  EXPECT_GT(paths.hiddenPart(), 0.3f);
  EXPECT_NEAR(mirrored + double(paths.hiddenPart()), 1, 1e-2);
  paths.removeMirrored();
  EXPECT_NEAR(double(luminance(meanThroughput(paths))), all - mirrored, 1e-5);
}

TEST(Paths, AnInfiniteWhiteWallBouncesWhatItBlocks) {
  OneTexel texel(test::lambert());
  test::addQuad(texel.scene, {-1, 0, 4000}, {0, 0, -8000}, {0, 4000, 0}, vec2(2), vec2(3));
  texel.map = makeTexels(texel.scene, 1, 1);
  texel.map.texels[0].pieceCount = 2;  // the quad's own pieces
  const Intersector world(texel.scene);
  KernelPaths one, all;
  PathTracer(world, {.bounces = 1}).traceLambert(texel.origin(), {1, 0, 0}, 16384, one);
  EXPECT_NEAR(meanThroughput(one).x, 0.5, 2e-3);
  PathTracer(world, {}).traceLambert(texel.origin(), {1, 0, 0}, 16384, all);
  // The wall's own kernel is a half-sphere of which half lies below the horizon of the floor: it escapes
  // there.
  EXPECT_NEAR(meanThroughput(all).x, 1, 1e-2);
  const auto straight = [](const KernelPaths& paths) {
    return std::count_if(paths.deposits.begin(), paths.deposits.end(),
                         [](const Deposit& d) { return d.straight; });
  };
  EXPECT_EQ(size_t(straight(one)), one.deposits.size());
  EXPECT_EQ(size_t(straight(all)), one.deposits.size());
}

TEST(Paths, DirectionCellsSeeWhatTheirDirectionsMeet) {
  OneTexel texel(test::metal(0.2f));
  texel.scene.materials.push_back(test::lambert());
  test::addQuad(texel.scene, {-1, 0, 4000}, {0, 0, -8000}, {0, 4000, 0}, vec2(2), vec2(3), 1);  // a wall
  texel.map = makeTexels(texel.scene, 1, 1);
  texel.map.texels[0].pieceCount = 2;  // the quad's own pieces
  const Intersector world(texel.scene);
  const auto trace = [&](vec3 towards) {
    KernelPaths paths;
    const DirectionCell cell{glm::normalize(towards), 0.99f, 0.02f};
    PathTracer(world, {}).traceIncident(texel.origin(), cell, {1, 0, 0}, 8192, paths);
    return paths;
  };
  const KernelPaths wall = trace({-1, 0.7f, 0}), open = trace({1, 0.7f, 0}), both = trace({0, 1, 0}),
                    edge = trace({1, 0, 0});
  EXPECT_NEAR(wall.traced, 8192, 20);
  EXPECT_GT(wall.hiddenPart(), 0.998f);
  EXPECT_NEAR(meanThroughput(wall).x, 1, 1e-2);
  EXPECT_LT(open.hiddenPart(), 2e-3f);  // the lobe's tail
  EXPECT_LT(open.deposits.size(), 16u);
  EXPECT_NEAR(both.hiddenPart(), 0.5f, 1e-2f);
  EXPECT_NEAR(meanThroughput(both).x, 0.5f, 1e-2f);
  EXPECT_NEAR(edge.traced, 4096, 200);  // those below the horizon are no part of the cell
  EXPECT_LT(edge.hiddenPart(), 2e-3f);
}

TEST(Paths, DirectionCellsAreCapsSpreadByTheLobe) {
  OneTexel texel(test::metal(0.2f));
  test::addQuad(texel.scene, {-50, 8, -50}, {100, 0, 0}, {0, 0, 100}, vec2(2), vec2(3));  // a black lid
  texel.scene.materials.push_back(test::lambert(Rgb(0)));
  for (size_t t = 2; t < texel.scene.triangles.size(); ++t) texel.scene.triangles[t].material = 1;
  const Intersector world(texel.scene);
  // Of a cap of 60 degrees, the lid leaves out what is more than 80.9 degrees from the axis: nothing. The
  // lobe turns directions by twice the angle of its half vectors, tan^2 = alpha^2 u / (1 - u).
  for (const float alpha : {1e-4f, 0.5f, 1.0f}) {
    KernelPaths paths;
    PathTracer(world, {}).traceIncident(texel.origin(), {{0, 1, 0}, 1.0f, alpha}, {1, 0, 0}, 16384, paths);
    // Up to half vectors of 45 degrees from the axis reflect above the horizon: u = 1 / (1 + alpha^2).
    const double above = 1 / (1 + double(alpha) * double(alpha));
    EXPECT_NEAR(paths.traced / 16384.0, above, 1e-2) << alpha;
  }
  KernelPaths cap;
  PathTracer(world, {}).traceIncident(texel.origin(), {{0, 1, 0}, -1.0f, 1e-4f}, {1, 0, 0}, 16384, cap);
  EXPECT_NEAR(cap.traced / 16384.0, 0.5, 1e-2);  // a cap that is the whole sphere
}

TEST(Paths, TheLimitOfThroughputsSaysWhatItTakes) {
  OneTexel texel(test::lambert());
  const PathOrigin origin = texel.origin();
  const Intersector world(texel.scene);
  KernelPaths paths;
  PathTracer(world, {.throughput = 0.25f}).traceLambert(origin, {1, 0, 0}, 256, paths);
  EXPECT_EQ(meanThroughput(paths), Rgb(0.25f));
  EXPECT_NEAR(paths.removed, 0.75 * 256, 1e-3);
}

TEST(Paths, MaskedPointsAreNoPartOfTheTexel) {
  asset::Material material = test::lambert();
  material.flags = asset::kAlphaMask;
  material.baseColor[3] = 0.1f;
  OneTexel texel(material);
  const PathOrigin origin = texel.origin();
  const Intersector world(texel.scene);
  KernelPaths paths;
  PathTracer(world, {}).traceLambert(origin, {1, 0, 0}, 64, paths);
  EXPECT_EQ(paths.traced, 0u);
  EXPECT_TRUE(paths.deposits.empty());
}

TEST(Paths, BothSidesOfASheetSeeTheirOwnHalfOfTheWorld) {
  OneTexel texel(test::lambert());
  const PathOrigin front = texel.origin(false), back = texel.origin(true);
  const Intersector world(texel.scene);
  KernelPaths above, below;
  const PathTracer tracer(world, {});
  tracer.traceLambert(front, {1, 0, 0}, 256, above);
  tracer.traceLambert(back, {1, 0, 0}, 256, below);
  for (const Deposit& d : above.deposits) EXPECT_LT(d.uv.y, 0.5f);
  for (const Deposit& d : below.deposits) EXPECT_GT(d.uv.y, 0.5f);
}

TEST(TexelBake, StoresWhatTheMaterialAsksFor) {
  const ViewSphere sphere(3);
  for (bool glossy : {false, true}) {
    OneTexel texel(glossy ? test::metal(0.3f) : test::lambert());
    texel.map = makeTexels(texel.scene, 1, 1);
    const Intersector world(texel.scene);
    const auto plans = planRecords(world, texel.map);
    ASSERT_EQ(plans.size(), 1u);
    const KernelOptions options{.paths = 64, .boxes = 4};
    TexelBaker baker(world, texel.map, sphere, options);
    const RecordKernels kernels = baker.bake(plans[0], options.glossySlots(plans[0]));
    EXPECT_EQ(kernels.lambert.slots.size(), glossy ? 0u : 16u);
    ASSERT_EQ(kernels.glossy.size(), glossy ? 92u : 0u);
    size_t stored = 0;
    for (const RecordKernel& kernel : kernels.glossy) {
      const std::vector<PackedBox>& view = kernel.slots;
      EXPECT_TRUE(view.empty() || view.size() == 4u);
      stored += !view.empty();
      float energy = 0;
      for (const PackedBox& box : view) energy += unpackBox(box).energy.x;
      if (view.empty()) continue;
      EXPECT_NEAR(energy, 1, 0.05);  // under a constant light the demodulated kernel returns 1
    }
    if (glossy) {
      EXPECT_NEAR(double(stored), 63, 5);
    }
  }
}

TEST(TexelBake, DoubleSidedTexelsHaveTwoRecords) {
  asset::Material material = test::lambert();
  material.flags = asset::kDoubleSided;
  OneTexel texel(material);
  texel.map = makeTexels(texel.scene, 1, 1);
  const Intersector world(texel.scene);
  const auto plans = planRecords(world, texel.map);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].record.normal[1], 1);
  EXPECT_EQ(plans[1].record.normal[1], -1);
  const auto atlas = indirection(texel.map, 0, plans);
  EXPECT_EQ(atlas[0].front, 0u);
  EXPECT_EQ(atlas[0].back, 1u);
}

TEST(TexelBake, EmittersHaveASlotOfTheirOwn) {
  for (bool glossy : {false, true}) {
    OneTexel texel(glossy ? test::metal(0.3f) : test::lambert());
    texel.map = makeTexels(texel.scene, 1, 1);
    asset::Material lamp = test::lambert({0.25f, 0.5f, 1});
    lamp.flags = asset::kUnlit;
    texel.scene.materials.push_back(lamp);
    test::addBox(texel.scene, vec3(-5), vec3(5), 1);  // all that the texel sees
    const Intersector world(texel.scene);
    const BakedScene baked = bakeScene(world, texel.map, planRecords(world, texel.map), ViewSphere(3),
                                       {.paths = 64, .boxes = 4}, ProgressStyle::none);
    ASSERT_EQ(baked.asset.tiles.size(), 1u);
    const asset::Tile& tile = baked.asset.tiles[0];
    int kernels = 0;
    for (const std::vector<PackedBox>& page : baked.pages) {
      if (page.empty()) continue;
      ++kernels;
      ASSERT_EQ(page.size(), glossy ? tile.glossyBoxes : tile.diffuseBoxes);
      const Rgb emitted = unpackEmission(page[0]);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(emitted[c] / lamp.baseColor[c], 1, glossy ? 0.05f : 2e-3f);
      for (size_t slot = 1; slot < page.size(); ++slot) EXPECT_EQ(unpackBox(page[slot]).energy, Rgb(0));
    }
    EXPECT_NEAR(kernels, glossy ? 63 : 1, glossy ? 5 : 0);
  }
}
