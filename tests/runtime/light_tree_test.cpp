// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_tree.h"

#include <gtest/gtest.h>

#include <bit>

#include "common/light/light_map.h"
#include "common/light/light_moments.h"
#include "runtime/light/light.h"
#include "shaders/shared.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

class LightTreeTest : public GpuTest {
 protected:
  /// The device's moments in the cells of all trees, and its bright texels, against the CPU's.
  void expectEqual(const Image& image) {
    const gpu::LightSettings settings{.size = {512, 256}, .moments = true, .lightTrees = true};
    gpu::Light light(*device_, image, {}, settings);
    device_->run([&](gpu::Commands& commands) { light.build(commands); });
    light.show();
    const LightMoments expected(makeLightMap(image, settings.size));
    const auto table = gpu::readBuffer<uvec4>(*device_, light.moments(), gpu::kMomentEnd);
    expectBright(expected, table, double(light.momentUnit()));
    for (uint32_t root = 0; root < kTreeRoots; ++root)
      for (TreeCell cell{root}; !cell.isEnd();) {
        expectCell(cell, expected.tree().cell(cell), &table[gpu::kMomentTree + 3 * cell.place()],
                   double(light.momentUnit()));
        if (cell.level > 0)
          cell.enter();
        else
          cell.pass();
      }
  }

 private:
  static void expectBright(const LightMoments& expected, const std::vector<uvec4>& table, double unit) {
    ASSERT_EQ(table[gpu::kMomentBright].x, expected.brightTexels().size());
    for (size_t i = 0; i < expected.brightTexels().size(); ++i) {
      const auto& bright = expected.brightTexels()[i];
      const uvec4* axis = &table[gpu::kMomentBright + 1 + 3 * i];
      EXPECT_EQ(uvec2(axis[1].w, axis[2].w), bright.at);
      for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(unit * double(int32_t(axis[k][c])), bright.light[c][k],
                      1e-3 * glm::length(bright.light[c]));
    }
  }

  static void expectCell(const TreeCell& at, const LightCell& cell, const uvec4* axis, double unit) {
    const auto value = [&](int k, int c) { return double(std::bit_cast<float>(axis[k][c])); };
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(value(k, 3), cell.one[k], 1e-6) << at.root << ' ' << at.level << ' ' << at.leaf;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(unit * value(k, c), cell.light[c][k], 1e-4 * glm::length(cell.light[c]))
            << at.root << ' ' << at.level << ' ' << at.leaf;
    }
  }
};

TEST_F(LightTreeTest, EqualsTheCpus) { expectEqual(noisyMap({512, 256}, 1.0f)); }
TEST_F(LightTreeTest, EqualsTheCpusWithASun) { expectEqual(noisyMap({1024, 512}, 1e6f)); }

/// More texels than are counted one by one: both take the same of them.
TEST_F(LightTreeTest, EqualsTheCpusUnderALamp) {
  Image image = noisyMap({256, 128}, 1.0f);
  for (uint32_t y = 20; y < 32; ++y)
    for (uint32_t x = 100; x < 120; ++x) std::fill_n(image.at(x, y), 3, 60.0f);
  expectEqual(image);
}

TEST_F(LightTreeTest, EqualsTheCpusInTheDark) { expectEqual(constantEnvironment({64, 32}, Rgb(0.0f))); }

}  // namespace
}  // namespace boxlight
