// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/extreme_maps.h"

#include <random>

#include "common/light/environment.h"

namespace boxlight::test {
namespace {

constexpr uvec2 kSize(512, 256);
constexpr uint32_t kColumn = 128, kRow = 256;  // of the grid in a texel

Image constant(float value) {
  Image image = makeImage(kSize.x, kSize.y, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

void setTexel(Image& image, uint32_t x, uint32_t y, float value) { std::fill_n(image.at(x, y), 3, value); }

/// One texel, 38 degrees high, in a sky of 1.
Image sun(float radiance) {
  Image image = constant(1.0f);
  setTexel(image, 310, 74, radiance);
  return image;
}

Image stars() {
  Image image = constant(0.0f);
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i)
    setTexel(image, uint32_t(random() % kSize.x), uint32_t(random() % kSize.y),
             float(1 + random() % 1000) * 0.01f);
  return image;
}

Image lit() {
  Image image = constant(0.0f);
  setTexel(image, 0, kSize.y - 1, 1.0f);
  return image;
}

/// A half float's range: its largest number among its smallest.
Image halfRange() {
  Image image = constant(0x1p-14f);
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i)
    setTexel(image, uint32_t(random() % kSize.x), uint32_t(random() % kSize.y), 65504.0f);
  return image;
}

Image subnormal() {
  Image image = constant(1e-41f);
  setTexel(image, 100, 100, 1.0f);
  return toEnvironment(std::move(image), "subnormal numbers");
}

}  // namespace

const std::vector<ExtremeMap>& extremeMaps() {
  static const std::vector<ExtremeMap> maps = {{"uniform white", constant(1.0f)},
                                               {"sun of 1e4 in a sky of 1", sun(1e4f)},
                                               {"sun of 1e6", sun(1e6f)},
                                               {"sun of 1e9", sun(1e9f)},
                                               {"2000 stars, else black", stars()},
                                               {"one lit texel at the south pole", lit()},
                                               {"half floats from 2^-14 to 65504", halfRange()},
                                               {"subnormal floats and a texel of 1", subnormal()},
                                               {"all black", constant(0.0f)}};
  return maps;
}

std::vector<BoxKind> boxKinds() {
  std::mt19937 random(5);
  const auto below = [&](uint32_t n) { return uint32_t(random() % n); };
  BoxKind small{"1/128 x 1/256 of a texel", {}}, few{"one to three texels, between texels", {}},
      ring{"full ring", {}}, pole{"at a pole", {}}, seam{"across the seam", {}},
      sphere{"whole sphere", {{0, 0, 65536, 65536}, {30000, 0, 65536, 65536}}}, any{"any", {}};
  for (int i = 0; i < 300; ++i) {
    small.boxes.push_back({below(65536), below(65536), 1, 1});
    few.boxes.push_back(
        {below(65536), below(65536 - 3 * kRow), kColumn + below(2 * kColumn), kRow + below(2 * kRow)});
    const uint32_t height = 1 + below(8 * kRow);
    ring.boxes.push_back({below(65536), below(65536 - height), 65536, height});
    pole.boxes.push_back({below(65536), i % 2 ? 0 : 65536 - height, 1 + below(65536), height});
    seam.boxes.push_back({65536 - kColumn, below(65536 - height), 2 * kColumn, height});
  }
  for (int i = 0; i < 100; ++i) {
    const uint32_t height = 1 + below(65536);
    any.boxes.push_back({below(65536), below(65536 - height + 1), 1 + below(65536), height});
  }
  return {small, few, ring, pole, seam, sphere, any};
}

std::vector<GridBox> texelBoxes() {
  std::vector<GridBox> boxes;
  for (uint32_t y = 0; y < kSize.y; ++y)
    for (uint32_t x = 0; x < kSize.x; ++x) boxes.push_back({x * kColumn, y * kRow, kColumn, kRow});
  return boxes;
}

}  // namespace boxlight::test
