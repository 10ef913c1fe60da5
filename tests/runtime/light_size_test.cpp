// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_size.h"

#include "tests/runtime/synthetic.h"
#include "tests/support/temporary_path.h"

namespace boxlight {
namespace {

constexpr uvec2 kLargeImage(8192, 4096);

class LightSizeTest : public testing::Test {
 protected:
  ~LightSizeTest() override { std::filesystem::remove(path_); }
  /// Each kernel: one box of `size` with `part` of the energy, one of a quarter each way with the rest.
  uvec2 choose(vec2 size, float part, uvec2 image = kLargeImage) {
    Square square;
    square.diffuseBoxes = 2;
    const auto reader = square.write(path_, [&](uint32_t, uint32_t, uint32_t slot) {
      return slot == 0 ? Box{0.5f, 0.5f, size.x, size.y, Rgb(part)} : Box{0, 0, 0.25f, 0.25f, Rgb(1 - part)};
    });
    return gpu::chooseLightSize(reader, image);
  }

  std::filesystem::path path_ = test::temporaryPath("light-size.ptb");
};

TEST_F(LightSizeTest, FollowsTheSmallBoxesThatHaveEnergy) {
  EXPECT_EQ(choose({0.1f, 0.1f}, 0.5f), gpu::kLeastLightSize);
  EXPECT_EQ(choose({1.0f / 512, 0.1f}, 0.5f), uvec2(1024, 256));
  EXPECT_EQ(choose({0.1f, 1.0f / 512}, 0.5f), uvec2(512, 1024));
  EXPECT_EQ(choose({1e-4f, 1e-4f}, 0.06f), gpu::kMostLightSize);
  EXPECT_EQ(choose({1e-4f, 1e-4f}, 0.04f), gpu::kLeastLightSize) << "a twentieth is left out";
}

TEST_F(LightSizeTest, IsNoMoreThanHalfAsFineAsTheImage) {
  EXPECT_EQ(choose({1e-4f, 1e-4f}, 0.5f, {1024, 512}), uvec2(512, 256));
  EXPECT_EQ(choose({1e-4f, 1e-4f}, 0.5f, {2048, 1024}), uvec2(1024, 512));
  EXPECT_EQ(choose({1e-4f, 1e-4f}, 0.5f, {1, 1}), gpu::kLeastLightSize);
}

TEST_F(LightSizeTest, SplitLobesCountByTheirRoughness) {
  for (const auto& [roughness, size] :
       {std::pair{0.5f, uvec2(512, 256)}, std::pair{0.1f, uvec2(2048, 1024)}}) {
    Square square;
    square.glossyBoxes = 2;
    square.visibility = [](uint32_t) { return VisibilityMap(); };
    asset::Asset asset = square.makeAsset();
    for (auto& record : asset.records) record.roughness = roughness;
    const auto reader = writeSynthetic(path_, asset, [&](uint32_t stream, uint32_t, uint32_t slot) {
      return slot == 0 && stream != asset.diffuseStream() ? packHiddenPart(0.5f)
                                                          : packBox({0, 0, 0.5f, 0.5f, Rgb(1)});
    });
    EXPECT_EQ(gpu::chooseLightSize(reader, kLargeImage), size) << roughness;
  }
}

}  // namespace
}  // namespace boxlight
