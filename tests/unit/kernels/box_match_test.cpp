// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bake/kernels/box_fit.h"
#include "common/light/light_domain.h"
#include "common/light/relight.h"
#include "tests/support/kernel_lab.h"

namespace boxlight {
namespace {

using Kernels = std::vector<std::vector<Box>>;
using lab::Random;

float energyOf(const Box& box) { return box.energy.x + box.energy.y + box.energy.z; }

Box boxAround(vec3 direction, float size, float energy) {
  const vec2 uv = directionToUv(direction);
  Box box;
  box.v0 = std::clamp(uv.y - 0.5f * size, 0.0f, 1.0f - size);
  box.dv = size;
  box.du = std::min(1.0f, size / std::max(0.1f, std::sin(kPi * uv.y)));
  box.u0 = uv.x - 0.5f * box.du - std::floor(uv.x - 0.5f * box.du);
  box.energy = Rgb(energy);
  return box;
}

/// Three boxes of known identity, told apart by their energies' colour: one follows the mirror direction, two
/// stay.
struct Moving {
  ViewSphere sphere{3};
  vec3 normal{0.0f, 0.0f, 1.0f};
  Kernels kernels;

  Moving() {
    const auto stored = viewsOfHemisphere(sphere, normal);
    kernels.resize(sphere.viewCount());
    for (uint32_t view = 0; view < sphere.viewCount(); ++view) {
      if (!stored[view]) continue;
      const vec3 eye = raiseAboveHorizon(sphere.directions()[view], normal);
      std::vector<Box> boxes = {boxAround(2.0f * glm::dot(normal, eye) * normal - eye, 0.1f, 3.0f),
                                boxAround({0.9f, 0.1f, 0.42f}, 0.1f, 3.1f),
                                boxAround({-0.8f, 0.2f, 0.56f}, 0.2f, 2.9f)};
      for (int identity = 0; identity < 3; ++identity) boxes[identity].energy *= tint(identity);
      std::rotate(boxes.begin(), boxes.begin() + view % 3, boxes.end());
      kernels[view] = boxes;
    }
  }
  static Rgb tint(int identity) {
    Rgb colour(0.0f);
    colour[identity] = 1.0f;
    return colour;
  }
  static int identityOf(const Box& box) { return box.energy.x > 0 ? 0 : box.energy.y > 0 ? 1 : 2; }
};

TEST(BoxMatch, FindsBoxesThatMoveAndBoxesThatStay) {
  Moving world;
  matchSlots(world.sphere, world.normal, world.kernels, 3);
  const std::vector<Box>* first = nullptr;
  for (const auto& kernel : world.kernels) {
    if (kernel.empty()) continue;
    if (!first) first = &kernel;
    ASSERT_EQ(kernel.size(), 3u);
    for (int slot = 0; slot < 3; ++slot)
      EXPECT_EQ(Moving::identityOf(kernel[slot]), Moving::identityOf((*first)[slot]));
  }
}

TEST(BoxMatch, MissingBoxesAreEmptyAndShapedLikeANeighbour) {
  Moving world;
  for (uint32_t view = 0; view < world.kernels.size(); view += 4) {
    auto& kernel = world.kernels[view];
    std::erase_if(kernel, [](const Box& box) { return Moving::identityOf(box) == 2; });
  }
  matchSlots(world.sphere, world.normal, world.kernels, 3);
  int empty = 0;
  for (const auto& kernel : world.kernels)
    for (const Box& box : kernel) {
      if (energyOf(box) > 0.0f) continue;
      ++empty;
      EXPECT_FLOAT_EQ(box.dv, 0.2f) << "the box that is missing is the large one";
    }
  EXPECT_GT(empty, 5);
}

TEST(BoxMatch, SlotsNobodyUsesAreEmptyButLegal) {
  Moving world;
  const Kernels before = world.kernels;
  matchSlots(world.sphere, world.normal, world.kernels, 7);
  for (size_t view = 0; view < before.size(); ++view) {
    EXPECT_EQ(world.kernels[view].size(), before[view].empty() ? 0u : 7u);
    for (size_t slot = 3; slot < world.kernels[view].size(); ++slot) {
      const Box& box = world.kernels[view][slot];
      EXPECT_EQ(energyOf(box), 0.0f);
      EXPECT_TRUE(box.du > 0.0f && box.dv > 0.0f && box.v0 + box.dv <= 1.0f);
    }
  }
}

TEST(BoxMatch, SlotsFallInEnergy) {
  Moving world;
  matchSlots(world.sphere, world.normal, world.kernels, 3);
  double sum[3] = {0, 0, 0};
  for (const auto& kernel : world.kernels)
    for (size_t slot = 0; slot < kernel.size(); ++slot) sum[slot] += energyOf(kernel[slot]);
  EXPECT_GE(sum[0], sum[1]);
  EXPECT_GE(sum[1], sum[2]);
}

TEST(BoxMatch, IslandsAndLoneViewsEnd) {
  Moving world;
  for (uint32_t view = 0; view < world.kernels.size(); ++view)
    if (view % 9 && view % 11) world.kernels[view].clear();
  matchSlots(world.sphere, world.normal, world.kernels, 3);
  Kernels none(world.sphere.viewCount());
  matchSlots(world.sphere, world.normal, none, 8);
  for (const auto& kernel : none) EXPECT_TRUE(kernel.empty());
}

/// Errors of kernels interpolated between the views, slots matched and slots by falling energy.
struct InterpolationErrors {
  double matched = 0, sorted = 0;
};

std::vector<Box> interpolate(const Kernels& kernels, const ViewBlend& blend, size_t slots) {
  std::vector<Box> boxes;
  for (size_t slot = 0; slot < slots; ++slot) {
    const InterpolatedBox box = interpolateBoxes(
        {kernels[blend.view[0]][slot], kernels[blend.view[1]][slot], kernels[blend.view[2]][slot]},
        blend.weight, Interpolation::energy);
    if (box.energy == dvec3(0.0)) continue;
    const Rectangle& r = box.rectangle;
    boxes.push_back({float(r.u0), float(r.v0), float(r.du), float(r.dv), Rgb(box.energy)});
  }
  return boxes;
}

InterpolationErrors measureInterpolation(float alpha) {
  constexpr int kPaths = 512, kTruthPaths = 8192, kTexels = 8, kViews = 4;
  constexpr size_t kSlots = 8;
  const ViewSphere sphere(3);
  std::vector<lab::Light> lights;
  std::vector<SummedArea> tables;
  for (uint64_t i = 0; i < 6; ++i)
    tables.push_back(lab::tableOf(lights.emplace_back(lab::makeLight(i, false))));
  lab::RelativeError matchedError, sortedError;
  BoxFitter fitter({.boxes = int(kSlots)});
  for (uint64_t t = 0; t < kTexels; ++t) {
    Random random(t);
    const lab::GlossyTexel texel(t, alpha);
    const auto stored = viewsOfHemisphere(sphere, texel.normal());
    Kernels sorted(sphere.viewCount());
    for (uint32_t view = 0; view < sphere.viewCount(); ++view) {
      if (!stored[view]) continue;
      const vec3 eye = raiseAboveHorizon(sphere.directions()[view], texel.normal());
      sorted[view] = fitter.fit(texel.trace(eye, kPaths, random), kPaths);
    }
    Kernels matched = sorted;
    matchSlots(sphere, texel.normal(), matched, kSlots);
    for (auto& kernel : sorted)
      if (!kernel.empty()) kernel.resize(kSlots);
    for (int v = 0; v < kViews; ++v) {
      const vec3 view = texel.anyView(0.2f, random);
      const ViewBlend blend = sphere.locate(view);
      const auto truth = texel.trace(view, kTruthPaths, random);
      for (size_t l = 0; l < lights.size(); ++l) {
        const dvec3 expected = lab::relight(truth, kTruthPaths, lights[l]);
        matchedError.add(l, lab::relight(interpolate(matched, blend, kSlots), tables[l]), expected);
        sortedError.add(l, lab::relight(interpolate(sorted, blend, kSlots), tables[l]), expected);
      }
    }
  }
  return {matchedError.mean(), sortedError.mean()};
}

TEST(BoxMatch, MatchedSlotsInterpolateBetterThanSortedOnes) {
  const InterpolationErrors rough = measureInterpolation(0.3f), glossy = measureInterpolation(0.1f);
  RecordProperty("rough", std::to_string(rough.matched) + " against " + std::to_string(rough.sorted));
  RecordProperty("glossy", std::to_string(glossy.matched) + " against " + std::to_string(glossy.sorted));
  EXPECT_LT(rough.matched, 0.75 * rough.sorted);
  EXPECT_LT(glossy.matched, 0.85 * glossy.sorted);
}

}  // namespace
}  // namespace boxlight
