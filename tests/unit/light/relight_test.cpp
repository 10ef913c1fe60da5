// SPDX-License-Identifier: Apache-2.0
#include "common/light/relight.h"
#include "common/light/light_domain.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>

namespace boxlight {
namespace {

Box makeBox(float u0, float v0, float du, float dv, Rgb energy = Rgb(1.0f)) {
  return {u0, v0, du, dv, energy};
}

Box randomBox(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform;
  Box box;
  box.u0 = uniform(random);
  box.du = random() % 5 ? 0.01f + 0.98f * uniform(random) : 1.0f;
  box.v0 = random() % 3 ? 0.9f * uniform(random) : 0.0f;
  box.dv = random() % 3 ? (1.0f - box.v0) * (0.01f + 0.98f * uniform(random)) : 1.0f - box.v0;
  if (random() % 6) box.energy = {uniform(random), uniform(random), uniform(random)};
  return box;
}

vec3 randomWeight(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0.01f, 1.0f);
  const vec3 w(uniform(random), uniform(random), uniform(random));
  return w / (w.x + w.y + w.z);
}

void expectRectangle(const Rectangle& r, double u0, double v0, double du, double dv,
                     double tolerance = 1e-6) {
  EXPECT_NEAR(std::remainder(r.u0 - u0, 1.0), 0.0, tolerance);
  EXPECT_NEAR(r.v0, v0, tolerance);
  EXPECT_NEAR(r.du, du, tolerance);
  EXPECT_NEAR(r.dv, dv, tolerance);
}

SummedArea constantLight(float radiance) {
  Image map = makeImage(16, 8, 3);
  std::fill(map.pixels.begin(), map.pixels.end(), radiance);
  return SummedArea(map);
}

TEST(InterpolateBoxes, ACornerIsItself) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const std::array<Box, 3> boxes = {randomBox(random), randomBox(random), randomBox(random)};
    for (int k = 0; k < 3; ++k)
      for (const Interpolation kind : {Interpolation::energy, Interpolation::weight}) {
        vec3 weight(0.0f);
        weight[k] = 1.0f;
        const InterpolatedBox box = interpolateBoxes(boxes, weight, kind);
        if (boxes[k].energy == Rgb(0.0f)) {
          EXPECT_EQ(box.energy, dvec3(0.0));
          continue;
        }
        expectRectangle(box.rectangle, boxes[k].du < 1.0f ? boxes[k].u0 : 0.0, boxes[k].v0, boxes[k].du,
                        boxes[k].dv);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(box.energy[c], boxes[k].energy[c], 1e-6);
      }
  }
}

TEST(InterpolateBoxes, EnergyIsExactUnderConstantLight) {
  std::mt19937 random(2);
  const SummedArea light = constantLight(1.0f);
  for (int i = 0; i < 1000; ++i) {
    const std::array<Box, 3> boxes = {randomBox(random), randomBox(random), randomBox(random)};
    const vec3 weight = randomWeight(random);
    const InterpolatedBox box = interpolateBoxes(boxes, weight, Interpolation::energy);
    const Rectangle& r = box.rectangle;
    if (box.energy == dvec3(0.0)) continue;
    EXPECT_TRUE(r.u0 >= 0.0 && r.u0 < 1.0 && r.du > 0.0 && r.du <= 1.0 && r.v0 >= 0.0 && r.dv > 0.0 &&
                r.v0 + r.dv <= 1.0);
    const dvec3 radiance = box.energy / r.solidAngle() * light.integrate(r);
    for (int c = 0; c < 3; ++c) {
      const double expected = double(weight.x) * boxes[0].energy[c] + double(weight.y) * boxes[1].energy[c] +
                              double(weight.z) * boxes[2].energy[c];
      EXPECT_NEAR(radiance[c], expected, 1e-9);
    }
  }
}

TEST(InterpolateBoxes, SizesAndLatitudesAreLinear) {
  const std::array<Box, 3> boxes = {makeBox(0.25f, 0.1f, 0.1f, 0.2f), makeBox(0.15f, 0.3f, 0.3f, 0.2f),
                                    makeBox(0.2f, 0.2f, 0.2f, 0.4f)};
  const InterpolatedBox box = interpolateBoxes(boxes, {0.5f, 0.25f, 0.25f}, Interpolation::energy);
  expectRectangle(box.rectangle, 0.3 - 0.5 * 0.175, 0.175, 0.175, 0.25);
}

TEST(InterpolateBoxes, CentresAreMeanOnTheCircle) {
  const std::array<Box, 3> boxes = {makeBox(0.2f, 0.1f, 0.1f, 0.2f), makeBox(0.45f, 0.1f, 0.1f, 0.2f),
                                    makeBox(0.3f, 0.1f, 0.1f, 0.2f)};
  const double turn = std::atan2(0.25, 0.75) / (2 * kPiDouble);
  expectRectangle(interpolateBoxes(boxes, {0.75f, 0.25f, 0.0f}, Interpolation::energy).rectangle, 0.2 + turn,
                  0.1, 0.1, 0.2);
}

TEST(InterpolateBoxes, ACentreThatLeavesLeavesNoJump) {
  // Around the whole circle: whichever corner comes first, and however little it has to say.
  const std::array<Box, 3> boxes = {makeBox(0.0f, 0.4f, 0.1f, 0.1f), makeBox(0.4f, 0.4f, 0.1f, 0.1f),
                                    makeBox(0.65f, 0.4f, 0.1f, 0.1f)};
  for (int last = 0; last < 3; ++last) {
    vec3 edge(0.4f);
    edge[last] = 0, edge[(last + 1) % 3] = 0.6f;
    vec3 beside = edge * (1 - 1e-6f);
    beside[last] = 1e-6f;
    const auto at = interpolateBoxes(boxes, edge, Interpolation::energy).rectangle;
    const auto near = interpolateBoxes(boxes, beside, Interpolation::energy).rectangle;
    EXPECT_NEAR(at.u0, near.u0, 1e-5) << last;
  }
}

TEST(InterpolateBoxes, CentresGoTheShortWayRound) {
  const std::array<Box, 3> boxes = {makeBox(0.95f, 0.4f, 0.1f, 0.1f), makeBox(0.05f, 0.4f, 0.1f, 0.1f),
                                    makeBox(0.9f, 0.4f, 0.1f, 0.1f)};
  expectRectangle(interpolateBoxes(boxes, {0.5f, 0.5f, 0.0f}, Interpolation::energy).rectangle, 0.0, 0.4, 0.1,
                  0.1);
  expectRectangle(interpolateBoxes(boxes, {0.0f, 0.5f, 0.5f}, Interpolation::energy).rectangle, 0.975, 0.4,
                  0.1, 0.1);
}

TEST(InterpolateBoxes, AFullRingHasNoCentre) {
  for (const float ringStart : {0.0f, 0.3f, 0.77f}) {
    const std::array<Box, 3> boxes = {makeBox(ringStart, 0.0f, 1.0f, 0.1f), makeBox(0.5f, 0.0f, 0.2f, 0.1f),
                                      makeBox(0.6f, 0.0f, 0.2f, 0.1f)};
    const InterpolatedBox box = interpolateBoxes(boxes, {0.5f, 0.25f, 0.25f}, Interpolation::energy);
    expectRectangle(box.rectangle, 0.65 - 0.3, 0.0, 0.6, 0.1);
    const std::array<Box, 3> rings = {boxes[0], boxes[0], boxes[0]};
    EXPECT_EQ(interpolateBoxes(rings, {0.5f, 0.25f, 0.25f}, Interpolation::energy).rectangle.du, 1.0);
  }
}

TEST(InterpolateBoxes, AnEmptyBoxHasNoPlace) {
  const std::array<Box, 3> boxes = {makeBox(0.0f, 0.0f, 1e-5f, 1e-5f, Rgb(0.0f)),
                                    makeBox(0.5f, 0.3f, 0.2f, 0.1f), makeBox(0.6f, 0.3f, 0.2f, 0.1f)};
  const InterpolatedBox box = interpolateBoxes(boxes, {0.5f, 0.25f, 0.25f}, Interpolation::energy);
  expectRectangle(box.rectangle, 0.55, 0.3, 0.2, 0.1);
  EXPECT_NEAR(box.energy.x, 0.5, 1e-9) << "but it takes its share of the energy";
  EXPECT_EQ(
      interpolateBoxes({boxes[0], boxes[0], boxes[0]}, {0.5f, 0.3f, 0.2f}, Interpolation::energy).energy,
      dvec3(0.0));
}

TEST(InterpolateBoxes, WeightVariantIsTheLiteralSketch) {
  const std::array<Box, 3> boxes = {makeBox(0.5f, 0.4f, 0.02f, 0.02f), makeBox(0.4f, 0.3f, 0.22f, 0.22f),
                                    makeBox(0, 0, 1, 1)};
  const vec3 weight(0.5f, 0.5f, 0.0f);
  const InterpolatedBox literal = interpolateBoxes(boxes, weight, Interpolation::weight);
  const InterpolatedBox byEnergy = interpolateBoxes(boxes, weight, Interpolation::energy);
  const double omega = literal.rectangle.solidAngle();
  const double w = 0.5 / boxes[0].solidAngle() + 0.5 / boxes[1].solidAngle();
  EXPECT_NEAR(literal.energy.x / (w * omega), 1.0, 1e-6);
  EXPECT_NEAR(byEnergy.energy.x, 1.0, 1e-6);
  EXPECT_GT(literal.energy.x, 15.0) << "which is why it is only a variant";
}

/// An asset in memory: `records` records around the origin that face +Y, kernels given by (stream, record).
struct TestAsset {
  asset::Asset asset;
  std::map<std::pair<uint32_t, uint32_t>, std::vector<PackedBox>> kernels;
  int pagesRead = 0;

  explicit TestAsset(uint32_t records) {
    asset.info.viewFrequency = 3;
    asset.info.viewCount = 92;
    for (uint32_t r = 0; r < records; ++r) {
      asset::TexelRecord record{};
      record.normal[1] = 1.0f;
      asset.records.push_back(record);
    }
  }

  void put(uint32_t stream, uint32_t record, const std::vector<Box>& boxes) {
    auto& kernel = kernels[{stream, record}];
    for (const Box& box : boxes) kernel.push_back(packBox(box));
  }

  /// Tiles of up to 64 records, all with `glossy` and `diffuse` boxes a kernel.
  void finish(uint32_t glossy, uint32_t diffuse) {
    const auto count = uint32_t(asset.records.size());
    for (uint32_t first = 0; first < count; first += asset::kTileRecords)
      asset.tiles.push_back({first, std::min(asset::kTileRecords, count - first), glossy, diffuse});
    asset.streamMasks.assign(size_t(asset.streamCount()) * asset.tiles.size(), 0);
    for (const auto& [key, boxes] : kernels)
      asset.streamMasks[size_t(key.first) * asset.tiles.size() + key.second / 64] |= uint64_t(1)
                                                                                     << (key.second % 64);
  }

  PageProvider provider() {
    return [this](uint32_t stream, uint32_t tile) {
      ++pagesRead;
      std::vector<PackedBox> page;
      for (uint32_t r = tile * 64; r < tile * 64 + 64; ++r)
        if (const auto kernel = kernels.find({stream, r}); kernel != kernels.end())
          page.insert(page.end(), kernel->second.begin(), kernel->second.end());
      return page;
    };
  }
};

const vec3 kEye(0.3f, 2.0f, -0.4f);

TEST(Relight, FindsTheKernelOfARecord) {
  TestAsset test(130);
  for (uint32_t r = 0; r < 130; ++r)
    if (r % 3 != 1)
      test.put(92, r,
               {makeBox(0.1f, 0.2f, 0.3f, 0.4f, Rgb(float(r))), makeBox(0.1f, 0.2f, 0.3f, 0.4f, Rgb(0.5f))});
  test.finish(1, 2);
  Relighter relighter(test.asset, test.provider());
  const SummedArea light = constantLight(2.0f);
  for (uint32_t r = 0; r < 130; ++r) {
    const TexelRadiance radiance = relighter.relight(r, kEye, light);
    EXPECT_NEAR(radiance.diffuse.y, r % 3 != 1 ? 2.0 * (r + 0.5) : 0.0, 1e-9) << r;
    EXPECT_EQ(radiance.glossy, dvec3(0.0)) << "no glossy kernels at all";
    EXPECT_EQ(relighter.kernel(92, r).size(), r % 3 != 1 ? 2u : 0u);
  }
  EXPECT_EQ(test.pagesRead, 3) << "each page once";
}

TEST(Relight, GlossyBlendsTheThreeViews) {
  TestAsset test(1);
  const ViewBlend blend = ViewSphere(3).locate(glm::normalize(kEye));
  const float energy[3] = {1.0f, 2.0f, 4.0f};
  for (int k = 0; k < 3; ++k) test.put(blend.view[k], 0, {makeBox(0.1f, 0.2f, 0.3f, 0.4f, Rgb(energy[k]))});
  test.finish(1, 0);
  Relighter relighter(test.asset, test.provider());
  double expected = 0.0;
  for (int k = 0; k < 3; ++k) expected += double(blend.weight[k]) * energy[k];
  EXPECT_NEAR(relighter.relight(0, kEye, constantLight(1.0f)).glossy.x, expected, 1e-6);
}

TEST(Relight, MissingViewsAreLeftOut) {
  TestAsset test(1);
  const ViewBlend blend = ViewSphere(3).locate(glm::normalize(kEye));
  test.put(blend.view[0], 0, {makeBox(0.1f, 0.2f, 0.3f, 0.4f, Rgb(1.0f))});
  test.put(blend.view[2], 0, {makeBox(0.2f, 0.2f, 0.3f, 0.4f, Rgb(4.0f))});
  test.finish(1, 0);
  Relighter relighter(test.asset, test.provider());
  const double expected =
      (double(blend.weight[0]) + 4.0 * double(blend.weight[2])) / double(blend.weight[0] + blend.weight[2]);
  EXPECT_NEAR(relighter.relight(0, kEye, constantLight(1.0f)).glossy.x, expected, 1e-6);
}

TEST(Relight, SplitLobesAreBlendedViewByView) {
  TestAsset test(1);
  test.asset.scheme = asset::Scheme::split;
  test.asset.records[0].flags = asset::kSplitLobe;
  const ViewBlend blend = ViewSphere(3).locate(glm::normalize(kEye));
  const auto put = [&](int k, float hidden, Rgb emission, float energy) {
    test.kernels[{blend.view[k], 0}] = {packEmission(emission), packHiddenPart(hidden),
                                        packBox(makeBox(0.1f * float(k), 0.2f, 0.3f, 0.4f, Rgb(energy)))};
  };
  put(0, 0.5f, Rgb(3, 0, 0), 0.25f);
  put(2, 0.125f, Rgb(0, 5, 0), 0.0625f);  // view 1 hides nothing
  test.finish(3, 0);
  Relighter relighter(test.asset, test.provider());
  const double w0 = double(blend.weight[0]), w2 = double(blend.weight[2]);
  const TexelRadiance radiance = relighter.relight(0, kEye, constantLight(2.0f));
  EXPECT_NEAR(radiance.hidden, 0.5 * w0 + 0.125 * w2, 1e-6);
  EXPECT_NEAR(radiance.glossy.x, (3 + 0.5) * w0 + 0.125 * w2, 1e-6);
  EXPECT_NEAR(radiance.glossy.y, 0.5 * w0 + (5 + 0.125) * w2, 1e-6);
  EXPECT_NEAR(relighter.relight(0, kEye, constantLight(2.0f), 0, Interpolation::energy, 0).glossy.z, 0, 1e-9);
}

TEST(Relight, EyesBelowTheHorizonAreRaised) {
  TestAsset test(1);
  const vec3 eye(1.0f, -0.5f, 0.0f), raised = raiseAboveHorizon(glm::normalize(eye), {0, 1, 0});
  for (const uint32_t view : ViewSphere(3).locate(raised).view)
    test.put(view, 0, {makeBox(0, 0, 1, 1, Rgb(3.0f))});
  test.finish(1, 0);
  Relighter relighter(test.asset, test.provider());
  EXPECT_NEAR(relighter.relight(0, eye, constantLight(1.0f)).glossy.x, 3.0, 1e-6);
  EXPECT_TRUE(std::isfinite(relighter.relight(0, vec3(0.0f), constantLight(1.0f)).glossy.x))
      << "an eye on the texel";
}

TEST(Relight, GradientFollowsTheCosineLaw) {
  TestAsset test(1);
  const Box high = makeBox(0.4f, 0.2f, 0.02f, 0.02f, Rgb(1, 2, 3)),
            low = makeBox(0.4f, 0.6f, 0.1f, 0.1f, Rgb(9));
  test.put(92, 0, {high, low});  // the second lies below the horizon
  test.finish(1, 2);
  Relighter relighter(test.asset, test.provider());
  const dmat3 gradient = relighter.diffuse(0, constantLight(2.0f)).gradient;
  const dvec3 d = meanDirection(high.u0, high.v0, high.du, high.dv), n(0, 1, 0);
  const dvec3 bent = glm::normalize(dvec3(0.3, 1, -0.2)), change = bent - glm::dot(bent, n) * n;
  for (int c = 0; c < 3; ++c) {
    const double radiance = 2.0 * (c + 1), tilted = radiance * glm::dot(d, change) / d.y;
    EXPECT_NEAR(glm::dot(gradient[c], change), tilted, 1e-3 * radiance) << c;
    EXPECT_NEAR(glm::dot(gradient[c], n), radiance, 1e-3 * radiance) << "the cosine itself";
  }
}

TEST(Relight, BoxCountAndRotation) {
  TestAsset test(1);
  test.put(92, 0,
           {makeBox(0.25f, 0.25f, 0.25f, 0.25f, Rgb(4.0f)), makeBox(0.75f, 0.25f, 0.25f, 0.25f, Rgb(1.0f))});
  test.finish(0, 2);
  Relighter relighter(test.asset, test.provider());
  Image map = makeImage(4, 4, 3);
  for (uint32_t y = 0; y < 4; ++y) map.at(1, y)[0] = 1.0f;  // lit from u = .25 to .5
  const SummedArea light(map);
  EXPECT_NEAR(relighter.relight(0, kEye, light).diffuse.x, 4.0, 1e-9);
  EXPECT_NEAR(relighter.relight(0, kEye, light, 0.5).diffuse.x, 1.0, 1e-9)
      << "half a turn: the other box is lit";
  EXPECT_NEAR(relighter.relight(0, kEye, light, 0.125).diffuse.x, 2.0, 1e-9);
  EXPECT_NEAR(relighter.relight(0, kEye, light, 0.5, Interpolation::energy, 1).diffuse.x, 0.0, 1e-9);
  EXPECT_NEAR(relighter.relight(0, kEye, constantLight(1.0f), 0.0, Interpolation::energy, 1).diffuse.x, 4.0,
              1e-9);
}

}  // namespace
}  // namespace boxlight
