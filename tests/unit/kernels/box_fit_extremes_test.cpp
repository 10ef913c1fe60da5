// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "bake/kernels/box_fit.h"
#include "tests/support/kernel_lab.h"

namespace boxlight {
namespace {

using lab::Random;

/// Whatever the deposits: a legal kernel that keeps their energy.
void expectSane(const std::vector<Deposit>& deposits, uint64_t pathCount, FitOptions options = {}) {
  const auto boxes = BoxFitter(options).fit(deposits, pathCount);
  dvec3 mean(0.0);
  for (const Deposit& deposit : deposits) mean += dvec3(deposit.throughput) / double(pathCount);
  EXPECT_EQ(boxes.empty(), mean == dvec3(0.0));
  EXPECT_LE(int(boxes.size()), options.boxes);
  dvec3 total(0.0);
  for (const Box& box : boxes) {
    EXPECT_TRUE(box.u0 >= 0.0f && box.u0 < 1.0f) << box.u0;
    EXPECT_TRUE(box.du > 0.0f && box.du <= 1.0f) << box.du;
    EXPECT_TRUE(box.v0 >= 0.0f && box.dv > 0.0f && box.v0 + box.dv <= 1.0f) << box.v0 << ' ' << box.dv;
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(std::isfinite(box.energy[c]) && box.energy[c] >= 0.0f) << box.energy[c];
    EXPECT_TRUE(std::isfinite(maxComponent(box.weight())));
    total += dvec3(box.energy);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(total[c], mean[c], 1e-5 * mean[c]) << "channel " << c;
}

bool contains(const Box& box, vec2 uv) {
  const float right = uv.x - box.u0 - std::floor(uv.x - box.u0);
  return (right <= box.du || box.du == 1.0f) && uv.y >= box.v0 && uv.y <= box.v0 + box.dv;
}

TEST(BoxFitExtremes, NothingGivesNothing) {
  expectSane({}, 256);
  expectSane({{{0.5f, 0.5f}, Rgb(0.0f)}, {{0.1f, 0.2f}, Rgb(0.0f)}}, 256);
}

TEST(BoxFitExtremes, OneDepositIsOneSmallBoxAroundIt) {
  for (const vec2 uv : {vec2(0.37f, 0.61f), vec2(0.0f, 0.5f), vec2(0.99999f, 0.5f)}) {
    const std::vector<Deposit> deposits{{uv, {0.2f, 0.4f, 0.8f}}};
    expectSane(deposits, 1000);
    const auto boxes = BoxFitter({}).fit(deposits, 1000);
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(contains(boxes[0], uv));
    EXPECT_LT(boxes[0].du, 0.002f);
    EXPECT_LT(boxes[0].dv, 0.003f);
  }
}

TEST(BoxFitExtremes, TwoDepositsAcrossTheSeamAreOneBoxOverIt) {
  const std::vector<Deposit> deposits{{{0.98f, 0.5f}, Rgb(1.0f)}, {{0.03f, 0.52f}, Rgb(1.0f)}};
  expectSane(deposits, 100);
  const auto boxes = BoxFitter({}).fit(deposits, 100);
  ASSERT_EQ(boxes.size(), 1u);
  for (const Deposit& deposit : deposits) EXPECT_TRUE(contains(boxes[0], deposit.uv));
  EXPECT_LT(boxes[0].du, 0.06f);
}

TEST(BoxFitExtremes, ManyInOneDirection) {
  for (const vec2 uv : {vec2(0.37f, 0.61f), vec2(0.0f, 0.0f), vec2(0.5f, 1.0f), vec2(1.0f, 0.5f)}) {
    const std::vector<Deposit> deposits(500, {uv, {1.0f, 0.1f, 0.0f}});
    expectSane(deposits, 500);
    const auto boxes = BoxFitter({}).fit(deposits, 500);
    ASSERT_FALSE(boxes.empty());
    EXPECT_LT(boxes[0].du, 0.002f);
    EXPECT_LT(boxes[0].dv, 0.003f);
    EXPECT_NEAR(boxes[0].energy.x, 1.0f, 1e-5f);
  }
}

TEST(BoxFitExtremes, PolesAndSeam) {
  std::vector<Deposit> deposits;
  for (int i = 0; i < 64; ++i) {
    const float s = float(i) / 63.0f;
    deposits.push_back({{s, 0.0f}, Rgb(1.0f)});
    deposits.push_back({{s, 1.0f}, Rgb(1.0f)});
    deposits.push_back({{0.0f, s}, Rgb(0.5f)});
    deposits.push_back({{1.0f, s}, Rgb(0.5f)});
  }
  for (int gridSize : {2, 32, 64}) expectSane(deposits, 1000, {.boxes = 16, .gridSize = gridSize});
}

TEST(BoxFitExtremes, TwelveDecades) {
  Random random(7);
  std::vector<Deposit> deposits;
  for (int i = 0; i < 2000; ++i) {
    const auto value = [&] { return std::pow(10.0f, -6.0f + 12.0f * random.uniform()); };
    deposits.push_back({{random.uniform(), random.uniform()}, {value(), value(), value()}});
  }
  expectSane(deposits, 2000);
  expectSane(deposits, 2000, {.boxes = 64, .noise = 0.0f});
}

TEST(BoxFitExtremes, UpToTwentyFourDecadesAtRandom) {
  for (uint64_t seed = 0; seed < 1200; ++seed) {
    Random random(seed);
    std::vector<Deposit> deposits(1 + size_t(300.0f * random.uniform()));
    const float decades = 24.0f * random.uniform();
    const auto value = [&] { return std::pow(10.0f, decades * (random.uniform() - 0.5f)); };
    for (Deposit& deposit : deposits)
      deposit = {{random.uniform(), random.uniform()}, {value(), value(), value()}};
    for (int boxes : {1, 12}) expectSane(deposits, deposits.size(), {.boxes = boxes});
  }
}

TEST(BoxFitExtremes, FaintAndBrightChannelsTogether) {
  Random random(8);
  std::vector<Deposit> deposits;
  for (int i = 0; i < 300; ++i) {
    const Rgb throughput = i % 2 ? Rgb(1e6f, 0.0f, 0.0f) : Rgb(0.0f, 1e-6f, 1e-38f);
    deposits.push_back({{random.uniform(), random.uniform()}, throughput});
  }
  expectSane(deposits, 300);
}

TEST(BoxFitExtremes, OneFireflyAmongMany) {
  Random random(9);
  auto deposits = lab::rectangleDeposits({0.2, 0.2, 0.3, 0.3}, 1024, Rgb(1.0f), random);
  for (const float brightness : {1e3f, 1e6f, 1e12f}) {
    deposits.push_back({{0.8f, 0.8f}, Rgb(brightness)});
    expectSane(deposits, 2000);
    expectSane(deposits, 2000, {.boxes = 1});
    deposits.pop_back();
  }
}

TEST(BoxFitExtremes, TinyHugeAndFew) {
  Random random(10);
  for (const float scale : {1e-30f, 1e-10f, 1e10f, 1e30f}) {
    auto deposits = lab::rectangleDeposits({0.9, 0.1, 0.3, 0.4}, 400, Rgb(scale, 0.5f * scale, 0.0f), random);
    expectSane(deposits, 400);
    expectSane(deposits, 1'000'000'000'000ull);
  }
}

}  // namespace
}  // namespace boxlight
