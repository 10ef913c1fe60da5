// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light.h"

#include <array>
#include <cmath>

#include "common/light/environment.h"
#include "common/light/light_map.h"
#include "shaders/shared.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

/// The algorithm of the shaders in plain 64-bit integers, as words of the table.
std::vector<uint32_t> referenceTable(const Image& map, const gpu::FixedPoint& fixedPoint,
                                     gpu::SatScheme scheme) {
  const uint32_t stride = map.width + 1;
  const bool exact = scheme == gpu::SatScheme::exact;
  std::vector<std::array<uint64_t, 3>> sums(size_t(stride) * (map.height + 1));
  std::vector<uint32_t> table(sums.size() * (exact ? 6 : 4), 0);
  for (uint32_t y = 0; y < map.height; ++y) {
    std::array<uint64_t, 3> row{};
    for (uint32_t x = 0; x < map.width; ++x)
      for (uint32_t c = 0; c < 3; ++c) {
        const volatile float product = map.at(x, y)[c] * fixedPoint.rowFactors[y];
        row[c] += uint64_t(product);
        const size_t entry = size_t(y + 1) * stride + x + 1;
        const uint64_t sum = sums[entry][c] = sums[entry - stride][c] + row[c];
        if (exact) {
          table[entry * 6 + 2 * c] = uint32_t(sum);
          table[entry * 6 + 2 * c + 1] = uint32_t(sum >> 32);
          continue;
        }
        const uint64_t prefix = (sum + (uint64_t(1) << (gpu::kGuardBits - 1))) >> gpu::kGuardBits;
        table[entry * 4 + c] = uint32_t(prefix);
        table[entry * 4 + 3] |= uint32_t(prefix >> 32 & 1023) << 10 * c;
      }
  }
  return table;
}

class LightTableTest : public GpuTest {
 protected:
  /// Light map and table on the device, of both schemes and both ways to share the work, against the CPU's.
  void expectExact(const Image& environment, uvec2 size, EnvironmentTilt tilt = {}) {
    const Image map =
        tilt.isLevel() ? makeLightMap(environment, size) : makeTiltedMap(environment, size, tilt);
    const double total = gpu::strongestTotal(environment) * (tilt.isLevel() ? 1.0 : 1.5);
    for (const auto scheme : {gpu::SatScheme::compact, gpu::SatScheme::exact})
      for (const auto build : {gpu::SatBuild::threads, gpu::SatBuild::groups}) {
        gpu::Light light(*device_, environment, tilt, {size, scheme, build});
        device_->run([&](gpu::Commands& commands) { light.build(commands); });
        light.show();
        const auto made = read<float>(light.map(), map.pixels.size());
        EXPECT_TRUE(made == map.pixels) << "the map, " << environment.width << " to " << size.x;
        const auto fixedPoint = gpu::chooseFixedPoint(total, size, scheme);
        EXPECT_EQ(light.unit(), fixedPoint.unit);
        const auto expected = referenceTable(map, fixedPoint, scheme);
        EXPECT_TRUE(read<uint32_t>(light.table(), expected.size()) == expected)
            << size.x << "x" << size.y << (scheme == gpu::SatScheme::exact ? " exact" : " compact")
            << (build == gpu::SatBuild::groups ? ", groups" : ", threads");
      }
  }
  void expectExact(const Image& environment) {
    expectExact(environment, {environment.width, environment.height});
  }

 private:
  template <class T>
  std::vector<T> read(const gpu::Buffer& buffer, size_t count) {
    return gpu::readBuffer<T>(*device_, buffer, count);
  }
};

TEST_F(LightTableTest, EqualsIntegersOnTheCpu) { expectExact(noisyMap({512, 256}, 1.0f)); }
TEST_F(LightTableTest, EqualsIntegersOnTheCpuWithASun) { expectExact(noisyMap({512, 256}, 1e6f)); }
TEST_F(LightTableTest, EqualsIntegersOnTheCpuAtOddSizes) {
  expectExact(noisyMap({1, 1}, 3.0f));
  expectExact(noisyMap({67, 3}, 1e9f));
}
TEST_F(LightTableTest, EqualsIntegersOnTheCpuAtTheExtremes) {
  expectExact(constantEnvironment({64, 32}, Rgb(0.0f)));
  expectExact(constantEnvironment({64, 32}, Rgb(1e-15f, 0.0f, 1e-20f)));
  expectExact(constantEnvironment({64, 32}, Rgb(kMostRadiance, 1.0f, kLeastRadiance)));
}

TEST_F(LightTableTest, ResampledAsOnTheCpu) {
  expectExact(noisyMap({1024, 512}, 1e6f), {512, 256});
  expectExact(noisyMap({100, 37}, 1e6f), {256, 128});
  expectExact(noisyMap({301, 151}, 1e4f), {128, 64});
}

TEST_F(LightTableTest, TiltedAsOnTheCpu) {
  expectExact(noisyMap({256, 128}, 1e6f), {128, 64}, {30.0f, -75.0f});
  expectExact(noisyMap({67, 33}, 1e6f), {128, 64}, {-90.0f, 0.0f});
  expectExact(noisyMap({1024, 512}, 1e6f), {128, 64}, {0.0f, 180.0f});
  expectExact(noisyMap({1, 1}, 3.0f), {8, 4}, {1.0f, 2.0f});
  expectExact(noisyMap({2, 3}, 3.0f), {9, 5}, {10.0f, 20.0f});
}

TEST_F(LightTableTest, ShowsTheOldLightUntilTheNewOneIsBuilt) {
  gpu::Light light(*device_, constantEnvironment({16, 8}, Rgb(1)), {}, {{16, 8}});
  const auto build = [&] { device_->run([&](gpu::Commands& commands) { light.build(commands); }); };
  build();
  light.show();
  const auto words = [&] {
    return gpu::readBuffer<uint32_t>(*device_, light.table(), light.table().size() / 4);
  };
  const auto before = words();
  const float unit = light.unit();
  EXPECT_FALSE(light.needsBuild());
  light.setTilt({});
  EXPECT_FALSE(light.needsBuild()) << "nothing has changed";
  light.setEnvironment(noisyMap({32, 16}, 1000.0f));
  EXPECT_TRUE(light.needsBuild());
  build();
  EXPECT_EQ(words(), before);
  EXPECT_EQ(light.unit(), unit);
  light.show();
  EXPECT_NE(words(), before);
  EXPECT_NE(light.unit(), unit);
}

TEST(FixedPoint, LeavesRoomForTheDifferencesOfRoundedPrefixes) {
  for (const float sun : {0.0f, 1.0f, 1e6f, 1e12f}) {
    const Image map = noisyMap({64, 32}, sun);
    const auto fixedPoint =
        gpu::chooseFixedPoint(gpu::strongestTotal(map), {64, 32}, gpu::SatScheme::compact);
    const auto table = referenceTable(map, fixedPoint, gpu::SatScheme::compact);
    const uint32_t* last = &table[table.size() - 4];
    uint64_t strongest = 0;
    for (uint32_t c = 0; c < 3; ++c)
      strongest = std::max(strongest, uint64_t(last[c]) | uint64_t(last[3] >> 10 * c & 1023) << 32);
    EXPECT_LT(strongest, (uint64_t(1) << 42) - 4);
    EXPECT_GE(strongest, (uint64_t(1) << 42) - (uint64_t(1) << 27)) << "all bits are used";
  }
}

}  // namespace
}  // namespace boxlight
