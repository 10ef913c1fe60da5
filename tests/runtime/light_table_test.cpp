// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_table.h"

#include <cmath>
#include <random>

#include "common/light/environment.h"
#include "common/light/light_map.h"
#include "runtime/light/fixed_point.h"
#include "shaders/shared.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

/// The algorithm of the shaders in plain 64-bit integers.
std::vector<uvec4> referenceTable(const Image& map) {
  const gpu::FixedPoint fixedPoint = gpu::chooseFixedPoint(map);
  const uint32_t stride = map.width + 1;
  std::vector<std::array<uint64_t, 3>> sums(size_t(stride) * (map.height + 1));
  std::vector<uvec4> table(sums.size(), uvec4(0));
  for (uint32_t y = 0; y < map.height; ++y) {
    std::array<uint64_t, 3> row{};
    for (uint32_t x = 0; x < map.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const volatile float product = map.at(x, y)[c] * fixedPoint.rowFactors[y];
        row[c] += uint64_t(product);
        const size_t entry = size_t(y + 1) * stride + x + 1;
        sums[entry][c] = sums[entry - stride][c] + row[c];
        const uint64_t prefix = (sums[entry][c] + (uint64_t(1) << (gpu::kGuardBits - 1))) >> gpu::kGuardBits;
        table[entry][c] = uint32_t(prefix);
        table[entry].w |= uint32_t(prefix >> 32 & 1023) << 10 * c;
      }
  }
  return table;
}

Image noisyMap(uvec2 size, float sun) {
  Image map = makeImage(size.x, size.y, 3);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 2.0f);
  for (float& value : map.pixels) value = uniform(random);
  for (int c = 0; c < 3; ++c) map.at(size.x / 3, size.y / 4)[c] = sun;
  return map;
}

class LightTableTest : public GpuTest {
 protected:
  std::vector<uvec4> build(const Image& map) {
    gpu::Bindings bindings(*device_);
    const gpu::LightTable table(*device_, bindings, map);
    gpu::FrameConstants frame{};
    frame.lightSize = table.size();
    const auto constants = gpu::makeBuffer(*device_, "frame", std::vector{frame});
    bindings.set(gpu::kBindFrame, constants);
    device_->run([&](gpu::Commands& commands) { table.build(commands); });
    return gpu::readBuffer<uvec4>(*device_, table.entries(), table.entries().size() / sizeof(uvec4));
  }
  void expectExact(const Image& map) { EXPECT_TRUE(build(map) == referenceTable(map)); }
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
  expectExact(constantEnvironment({64, 32}, Rgb(1e30f, 1.0f, 0.0f)));
}

TEST(FixedPoint, KeepsOneBitForTheSign) {
  for (const float sun : {0.0f, 1.0f, 1e6f, 1e12f}) {
    const Image map = noisyMap({64, 32}, sun);
    const auto table = referenceTable(map);
    uint64_t strongest = 0;
    for (int c = 0; c < 3; ++c)
      strongest =
          std::max(strongest, uint64_t(table.back()[c]) | uint64_t(table.back().w >> 10 * c & 1023) << 32);
    EXPECT_LT(strongest, uint64_t(1) << 41);
    EXPECT_GE(strongest, uint64_t(1) << 39);
  }
}

}  // namespace
}  // namespace boxlight
