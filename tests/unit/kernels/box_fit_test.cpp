// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_fit.h"

#include <gtest/gtest.h>

#include "common/light/light_domain.h"
#include "tests/support/kernel_lab.h"

namespace boxlight {
namespace {

using lab::Random;

/// Half the distance of evenly spread lines at the default grid size, which holds half the lines.
constexpr float kGridStep = 1.0f / 16.0f;

std::vector<Box> fit(const std::vector<Deposit>& deposits, FitOptions options = {}) {
  return BoxFitter(options).fit(deposits, deposits.size());
}

float wrappedDistance(float a, float b) { return std::abs(a - b - std::round(a - b)); }

void expectRectangle(const Box& box, const Rectangle& truth, float tolerance) {
  EXPECT_LT(wrappedDistance(box.u0, float(truth.u0)), tolerance);
  EXPECT_NEAR(box.du, truth.du, 2.0f * tolerance);
  EXPECT_NEAR(box.v0, truth.v0, tolerance);
  EXPECT_NEAR(box.dv, truth.dv, 2.0f * tolerance);
}

TEST(BoxFit, ConstantKernelBecomesConstant) {
  Random random(1);
  const auto boxes = fit(lab::rectangleDeposits({0, 0, 1, 1}, 4096, {1.0f, 0.5f, 0.25f}, random));
  ASSERT_FALSE(boxes.empty());
  EXPECT_FLOAT_EQ(boxes[0].du, 1.0f);
  EXPECT_FLOAT_EQ(boxes[0].dv, 1.0f);
  EXPECT_GT(boxes[0].energy.x, 0.8f);
  const Rgb total = lab::totalEnergy(boxes);
  EXPECT_NEAR(total.x, 1.0f, 1e-6f);
  EXPECT_NEAR(total.y, 0.5f, 1e-6f);
  EXPECT_NEAR(total.z, 0.25f, 1e-6f);
}

struct RectangleCase {
  const char* name;
  Rectangle rectangle;
};

class BoxFitRectangle : public testing::TestWithParam<RectangleCase> {};

TEST_P(BoxFitRectangle, OneBoxRecoversIt) {
  Random random(2);
  const Rectangle truth = GetParam().rectangle;
  const auto boxes = fit(lab::rectangleDeposits(truth, 4096, Rgb(1.0f), random), {.boxes = 1});
  ASSERT_EQ(boxes.size(), 1u);
  expectRectangle(boxes[0], truth, 0.5f * kGridStep);
  EXPECT_NEAR(boxes[0].solidAngle(), truth.solidAngle(), 0.15 * truth.solidAngle());
  EXPECT_NEAR(boxes[0].energy.x, 1.0f, 1e-6f);
}

INSTANTIATE_TEST_SUITE_P(Cases, BoxFitRectangle,
                         testing::Values(RectangleCase{"aligned", {0.25, 0.25, 0.25, 0.5}},
                                         RectangleCase{"unaligned", {0.313, 0.271, 0.187, 0.233}},
                                         RectangleCase{"small", {0.7003, 0.4111, 0.021, 0.033}},
                                         RectangleCase{"overTheSeam", {0.93, 0.4, 0.15, 0.2}},
                                         RectangleCase{"northCap", {0, 0, 1, 0.1}},
                                         RectangleCase{"southCap", {0, 0.85, 1, 0.15}},
                                         RectangleCase{"ring", {0, 0.45, 1, 0.1}}),
                         [](const auto& instance) { return instance.param.name; });

TEST(BoxFit, TwoColoursAreTwoBoxes) {
  Random random(3);
  auto deposits = lab::rectangleDeposits({0.1, 0.3, 0.1, 0.2}, 1024, {1, 0, 0}, random);
  const auto blue = lab::rectangleDeposits({0.6, 0.5, 0.2, 0.1}, 1024, {0, 0, 1}, random);
  deposits.insert(deposits.end(), blue.begin(), blue.end());
  const auto boxes = fit(deposits, {.boxes = 2});
  ASSERT_EQ(boxes.size(), 2u);
  const Box& red = boxes[0].energy.x > boxes[1].energy.x ? boxes[0] : boxes[1];
  const Box& other = &red == &boxes[0] ? boxes[1] : boxes[0];
  expectRectangle(red, {0.1, 0.3, 0.1, 0.2}, 0.5f * kGridStep);
  expectRectangle(other, {0.6, 0.5, 0.2, 0.1}, 0.5f * kGridStep);
  EXPECT_NEAR(red.energy.x, 0.5f, 1e-3f);
  EXPECT_NEAR(other.energy.z, 0.5f, 1e-3f);
  EXPECT_EQ(red.energy.y, 0.0f);
}

/// Error of the fits of cosine lobes against the closed form of the light 1 + d.a: albedo (1 + 2/3 n.a).
double cosineError(FitOptions options) {
  lab::RelativeError error;
  for (uint64_t i = 0; i < 8; ++i) {
    Random random(i);
    const vec3 normal = random.direction(), axis = random.direction();
    const SummedArea light = lab::tableOf([&](vec3 d) { return Rgb(1.0f + glm::dot(d, axis)); });
    const auto fitted = fit(lab::cosineDeposits(normal, 16384, random), options);
    error.add(0, lab::relight(fitted, light), dvec3(1.0 + 2.0 / 3.0 * glm::dot(normal, axis)));
  }
  return error.mean();
}

TEST(BoxFit, CosineLobeErrorFallsWithBoxes) {
  const double one = cosineError({.boxes = 1}), four = cosineError({.boxes = 4}),
               sixteen = cosineError({.boxes = 16});
  EXPECT_LT(four, 0.75 * one);
  EXPECT_LT(sixteen, 0.5 * four);
  EXPECT_LT(sixteen, 0.01);
}

TEST(BoxFit, RefinementPays) {
  double refined = 0.0, inserted = 0.0;
  for (int boxes : {2, 3, 8}) {
    refined += cosineError({.boxes = boxes});
    inserted += cosineError({.boxes = boxes, .refinements = 0});
  }
  EXPECT_LT(refined, 0.9 * inserted);
}

/// Error of glossy fits from few paths under smooth lights.
double noisyError(float noise) {
  lab::RelativeError error;
  std::vector<lab::Light> lights;
  std::vector<SummedArea> tables;
  for (uint64_t i = 0; i < 6; ++i) {
    lights.push_back(lab::makeLight(i, false));
    tables.push_back(lab::tableOf(lights.back()));
  }
  BoxFitter fitter({.noise = noise});
  for (uint64_t i = 0; i < 24; ++i) {
    Random random(100 + i);
    const lab::GlossyTexel texel(i, 0.1f);
    const vec3 view = texel.anyView(0.2f, random);
    const auto boxes = fitter.fit(texel.trace(view, 96, random), 96);
    const auto truth = texel.trace(view, 8192, random);
    for (size_t l = 0; l < lights.size(); ++l)
      error.add(l, lab::relight(boxes, tables[l]), lab::relight(truth, 8192, lights[l]));
  }
  return error.mean();
}

TEST(BoxFit, NoiseTermPaysWithFewPaths) { EXPECT_LT(noisyError(4.0f), 0.95 * noisyError(0.0f)); }

TEST(BoxFit, NumberOfBoxesIsRespectedAndEnergyKept) {
  Random random(5);
  const lab::GlossyTexel texel(3, 0.1f);
  const auto deposits = texel.trace(texel.anyView(0.5f, random), 4096, random);
  dvec3 mean(0.0);
  for (const Deposit& deposit : deposits) mean += dvec3(deposit.throughput) / 4096.0;
  for (int count : {1, 2, 3, 8, 33, 64})
    for (int gridSize : {2, 5, 32, 64}) {
      const auto boxes = BoxFitter({.boxes = count, .gridSize = gridSize}).fit(deposits, 4096);
      EXPECT_LE(int(boxes.size()), count);
      EXPECT_GE(boxes.size(), 1u);
      const Rgb total = lab::totalEnergy(boxes);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(total[c] / mean[c], 1.0, 1e-6);
      for (size_t j = 1; j < boxes.size(); ++j)
        EXPECT_LE(boxes[j].energy.x + boxes[j].energy.y + boxes[j].energy.z,
                  boxes[j - 1].energy.x + boxes[j - 1].energy.y + boxes[j - 1].energy.z);
    }
}

TEST(BoxFit, AFitDoesNotDependOnEarlierOnes) {
  Random random(6);
  const lab::GlossyTexel texel(4, 0.2f);
  const auto first = texel.trace(texel.normal(), 512, random),
             second = texel.trace(texel.normal(), 300, random);
  BoxFitter reused({});
  reused.fit(first, 512);
  const auto again = reused.fit(second, 300), fresh = BoxFitter({}).fit(second, 300);
  ASSERT_EQ(again.size(), fresh.size());
  for (size_t j = 0; j < fresh.size(); ++j) {
    EXPECT_EQ(again[j].u0, fresh[j].u0);
    EXPECT_EQ(again[j].dv, fresh[j].dv);
    EXPECT_EQ(again[j].energy, fresh[j].energy);
  }
}

}  // namespace
}  // namespace boxlight
