// SPDX-License-Identifier: Apache-2.0
#include "common/light/box.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

namespace boxlight {
namespace {

Box makeBox(float u0, float v0, float du, float dv, Rgb energy = Rgb(1.0f)) {
  return {u0, v0, du, dv, energy};
}

TEST(Box, WeightTimesSolidAngleIsEnergy) {
  const Box hemisphere = makeBox(0.3f, 0.0f, 1.0f, 0.5f, {2, 4, 6});
  EXPECT_NEAR(hemisphere.solidAngle(), 2.0 * kPiDouble, 1e-12);
  EXPECT_NEAR(hemisphere.weight().y, 4.0 / (2.0 * kPiDouble), 1e-6);
  EXPECT_EQ(Box().weight(), Rgb(0.0f));
}

TEST(PackedBox, EdgesMoveByAtMostHalfAStepAndEnergiesByOneIn512) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform;
  const float half = 0.5f / 65536.0f + 1e-7f;
  for (int i = 0; i < 10000; ++i) {
    const float v0 = uniform(random) * 0.99f;
    const Box box = makeBox(uniform(random), v0, 1e-4f + 0.9998f * uniform(random),
                            (1.0f - v0) * (0.01f + 0.98f * uniform(random)),
                            {uniform(random), 100.0f * uniform(random), 0.0f});
    const Box back = unpackBox(packBox(box));
    EXPECT_NEAR(std::remainder(back.u0 - box.u0, 1.0f), 0.0f, half);
    EXPECT_NEAR(std::remainder(back.u0 + back.du - box.u0 - box.du, 1.0f), 0.0f, half);
    EXPECT_NEAR(back.v0, box.v0, half);
    EXPECT_NEAR(back.v0 + back.dv, box.v0 + box.dv, half);
    EXPECT_LE(back.v0 + back.dv, 1.0f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.energy[c], box.energy[c], box.energy[c] / 512.0f + 3e-8f);
  }
}

TEST(PackedBox, RingsPolesAndSeam) {
  const Box sphere = unpackBox(packBox(makeBox(0.25f, 0.0f, 1.0f, 1.0f)));
  EXPECT_EQ(sphere.du, 1.0f);
  EXPECT_EQ(sphere.v0, 0.0f);
  EXPECT_EQ(sphere.dv, 1.0f);
  const Box cap = unpackBox(packBox(makeBox(0.9f, 0.99f, 0.3f, 0.01f)));
  EXPECT_EQ(cap.v0 + cap.dv, 1.0f);
  EXPECT_NEAR(cap.du, 0.3f, 2e-5f);
  const Box seam = unpackBox(packBox(makeBox(0.999999f, 0.5f, 0.25f, 0.1f)));
  EXPECT_EQ(seam.u0, 0.0f);
  EXPECT_NEAR(seam.du, 0.25f, 2e-5f);
}

TEST(PackedBox, NeverEmptyInSize) {
  for (const Box& box : {Box(), makeBox(1.0f, 1.0f, 0.0f, 0.0f), makeBox(0.5f, 0.99999f, 1e-9f, 1e-9f)}) {
    const Box back = unpackBox(packBox(box));
    EXPECT_GT(back.du, 0.0f);
    EXPECT_GT(back.dv, 0.0f);
    EXPECT_LE(back.v0 + back.dv, 1.0f);
    EXPECT_TRUE(std::isfinite(back.weight().x));
  }
}

TEST(PackedBox, HugeEnergyIsClampedNotInfinite) {
  EXPECT_EQ(unpackBox(packBox(makeBox(0, 0, 1, 1, Rgb(1e9f)))).energy.x, 65408.0f);
  EXPECT_EQ(unpackBox(packBox(makeBox(0, 0, 1, 1, Rgb(65504)))).energy.x, 65408.0f);
  EXPECT_EQ(unpackCosineBox(packCosineBox({makeBox(0, 0, 1, 1), -1e9f})).amplitude, -65504.0f);
}

TEST(PackedBox, EnergiesHaveNineSignificantBitsAndNoBias) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(0.5f, 1.0f);
  constexpr int kBoxes = 100000;
  double sum = 0;
  for (int i = 0; i < kBoxes; ++i) {
    const float energy = uniform(random), half = std::round(energy * 2048.0f) / 2048.0f;
    const PackedBox packed = packBox(makeBox(0, 0, 1, 1, {energy, half, 0}));
    EXPECT_EQ((packed.energy[0] | packed.energy[1]) & 3, 0);
    sum += double(unpackBox(packed).energy.y - half);
  }
  EXPECT_LT(std::abs(sum / kBoxes), 4 * 5.6e-4 / std::sqrt(double(kBoxes)));  // of half floats, half way, too
  EXPECT_EQ(unpackBox(packBox(makeBox(0, 0, 1, 1, {1, 0.5f, 1.0f / 512}))).energy, Rgb(1, 0.5f, 1.0f / 512));
}

TEST(PackedBox, NoNumberStaysNone) {
  for (const uint32_t bits : {0x7FFFFFFFu, 0xFFFFFFFFu, 0x7FC00000u, 0x7F800001u, 0xFF800000u}) {
    const float energy = unpackBox(packBox(makeBox(0, 0, 1, 1, Rgb(std::bit_cast<float>(bits))))).energy.x;
    EXPECT_FALSE(energy >= 0) << bits;
  }
}

TEST(PackedBox, EveryCodeIsABox) {
  std::mt19937 random(3);
  for (int i = 0; i < 10000; ++i) {
    PackedBox packed;
    packed.u0 = uint16_t(random());
    packed.v0 = uint16_t(random());
    packed.du = uint16_t(random());
    packed.dv = uint16_t(random() % (65536u - packed.v0));
    const Box box = unpackBox(packed);
    EXPECT_TRUE(box.u0 >= 0.0f && box.u0 < 1.0f && box.du > 0.0f && box.du <= 1.0f &&
                box.v0 + box.dv <= 1.0f);
    const PackedBox again = packBox(box);
    EXPECT_EQ(std::memcmp(&again, &packed, sizeof packed), 0);
  }
}

}  // namespace
}  // namespace boxlight
