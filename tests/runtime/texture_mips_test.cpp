// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/texture_mips.h"

#include <gtest/gtest.h>

#include "common/image/image.h"

namespace boxlight::gpu {
namespace {

asset::Asset oneTexture(uint32_t width, uint32_t height, bool srgb, uint32_t minFilter) {
  asset::Asset asset;
  asset.textures = {{width, height, 0, asset::Wrap::repeat, asset::Wrap::repeat, srgb, 0, minFilter}};
  asset.texels.resize(size_t(width) * height);
  return asset;
}

TEST(TextureMips, OnlyWhereTheyAreUsed) {
  EXPECT_EQ(makeTextureSet(oneTexture(8, 8, false, 1)).levels.size(), 1u);
  const TextureSet set = makeTextureSet(oneTexture(8, 2, false, 2));
  ASSERT_EQ(set.levels.size(), 4u);
  EXPECT_EQ(set.levels[1].width, 4u);
  EXPECT_EQ(set.levels[1].height, 1u);
  EXPECT_EQ(set.levels[3].width, 1u);
  EXPECT_EQ(set.texels.size(), 16u + 4 + 2 + 1);
}

TEST(TextureMips, MeanIsTakenInLinearSpace) {
  asset::Asset asset = oneTexture(2, 1, true, 2);
  asset.texels = {0xFFFFFFFFu, 0x00000000u};
  const uint32_t word = makeTextureSet(asset).texels.back();
  EXPECT_EQ(word & 255, uint32_t(std::lround(encodeSrgb(0.5f) * 255)));
  EXPECT_EQ(word >> 24, 128u);  // alpha is linear
}

TEST(TextureMips, OddSizesKeepTheMean) {
  asset::Asset asset = oneTexture(5, 3, false, 2);
  uint32_t sum = 0;
  for (uint32_t i = 0; i < 15; ++i) asset.texels[i] = i * 17, sum += i * 17;
  const TextureSet set = makeTextureSet(asset);
  EXPECT_NEAR(double(set.texels.back() & 255), double(sum) / 15, 1.5);
}

}  // namespace
}  // namespace boxlight::gpu
