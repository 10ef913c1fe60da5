// SPDX-License-Identifier: Apache-2.0
// Equation 3 on the device against relight() in double precision, record by record.
#include "tests/runtime/oracle_fixture.h"

namespace boxlight {
namespace {

TEST_F(OracleTest, BoxesOfEverySizeAndPlace) {
  Square square;
  square.atlasEdge = 48;
  const auto reader = square.write(file("boxes.ptb"), randomBox);
  EXPECT_EQ(compare(reader, environmentWithSun(1.0f)), 48u * 48u);
}

TEST_F(OracleTest, ASunOfAMillion) {
  Square square;
  square.atlasEdge = 48;
  const auto reader = square.write(file("sun.ptb"), randomBox);
  EXPECT_EQ(compare(reader, environmentWithSun(1e6f)), 48u * 48u);
}

TEST_F(OracleTest, GradientsInTheNormal) {
  Square square;
  square.atlasEdge = 48;
  square.glossyBoxes = 2;
  square.diffuseBoxes = 3;
  square.texels = {0xFFE6CC80u};
  square.textures = {{1, 1, 0, asset::Wrap::repeat, asset::Wrap::repeat, 0, 1, 0}};
  square.material.normalTexture = {0, 0};
  isMapped_ = true;
  const auto reader = square.write(file("bent.ptb"), randomBox);
  EXPECT_EQ(compare(reader, environmentWithSun(10.0f)), 48u * 48u);
}

/// Cosine boxes of either sign, one in three the whole sphere, and light boxes between them.
PackedBox cosineKernel(uint32_t stream, uint32_t record, uint32_t slot) {
  std::mt19937 random(record * 31u + slot * 65537u);
  if (slot == 1 && record % 5 == 0) return {};  // an empty slot, and boxes behind it
  if (slot % 4 == 3) return packBox(randomBox(stream, record, slot));
  CosineBox cosine{{0, 0, 1, 1}, float(random() % 100) / 50.0f - 0.1f};
  if (random() % 3 == 0) return packCosineBox(cosine);
  const uint32_t top = random() % 127, rows = 1 + random() % (128 - top);
  cosine.box.v0 = float(top) / 128.0f;
  cosine.box.dv = float(rows) / 128.0f;
  cosine.box.u0 = float(random() % 65536) / 65536.0f;
  cosine.box.du = float(1 + random() % 65536) / 65536.0f;
  return packCosineBox(cosine);
}

TEST_F(OracleTest, CosineBoxes) {
  Square square;
  square.atlasEdge = 32;
  square.diffuseBoxes = 5;
  square.texels = {0xFFE6CC80u};
  square.textures = {{1, 1, 0, asset::Wrap::repeat, asset::Wrap::repeat, 0, 1, 0}};
  square.material.normalTexture = {0, 0};
  isMapped_ = true;
  asset::Asset asset = square.makeAsset();
  std::mt19937 random(17);
  std::normal_distribution<float> gauss;
  for (uint32_t r = 40; r < asset.records.size(); ++r) {  // they look everywhere, the first ones straight up
    const vec3 n = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    std::copy_n(&n.x, 3, asset.records[r].normal);
  }
  const auto reader = writeSynthetic(file("cosine.ptb"), asset, cosineKernel);
  tolerance_ = 5e-4;  // of a sky beside a sun that grazes the surface, and where boxes take from each other
  for (const float degrees : {0.0f, 123.4f, 359.9f}) {
    settings_.environmentDegrees = degrees;
    for (const float sun : {1.0f, 1e6f})
      EXPECT_EQ(compare(reader, environmentWithSun(sun)), 32u * 32u) << degrees << " " << sun;
  }
  settings_.lightSize = {100, 37};
  settings_.boxLimit = 3;
  EXPECT_EQ(compare(reader, environmentWithSun(10.0f)), 32u * 32u);
}

TEST_F(OracleTest, InterpolatesViews) {
  Square square;
  square.atlasEdge = 20;
  square.glossyBoxes = 4;
  square.diffuseBoxes = 3;
  const auto reader = square.write(file("views.ptb"), matchedBox);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};  // many view directions at once
  settings_.camera.tanHalfFov = 1.5f;
  for (const Interpolation interpolation : {Interpolation::energy, Interpolation::weight}) {
    settings_.interpolation = interpolation;
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
  }
}

TEST_F(OracleTest, TurnsTheLightAndLimitsTheBoxes) {
  Square square;
  square.atlasEdge = 16;
  square.glossyBoxes = 5;
  square.diffuseBoxes = 5;
  const auto reader = square.write(file("limits.ptb"), matchedBox);
  settings_.environmentDegrees = 123.4f;
  settings_.boxLimit = 3;
  settings_.lightSize = {100, 37};
  EXPECT_EQ(compare(reader, environmentWithSun(10.0f)), 16u * 16u);
}

TEST_F(OracleTest, PoolsMakeNoDifference) {
  Square square;
  square.atlasEdge = 16;
  square.glossyBoxes = 3;
  const auto reader = square.write(file("pools.ptb"), matchedBox);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  const Image light = environmentWithSun(1.0f);
  gpu::FrameRenderer one(*device_, reader, light, settings_);
  settings_.poolBytes = one.counts().pageBytes / 3;
  gpu::FrameRenderer several(*device_, reader, light, settings_);
  EXPECT_EQ(several.counts().pageBytes, one.counts().pageBytes);
  EXPECT_EQ(several.picture().pixels, one.picture().pixels);
  settings_.poolBytes = one.counts().pageBytes / 8;
  try {
    gpu::FrameRenderer tooMany(*device_, reader, light, settings_);
    FAIL() << "eight pools";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::runtime);
  }
}

TEST_F(OracleTest, KernelsThatAreNotThere) {
  Square square;
  square.atlasEdge = 16;
  square.glossyBoxes = 2;
  square.twoSided = true;
  square.material.flags = asset::kDoubleSided;
  const auto reader = square.write(file("sides.ptb"), matchedBox);  // each view lacks those of one side
  settings_.camera.eye = {0, -2, 0.01f};
  settings_.camera.forward = {0, 1, 0};
  settings_.camera.right = {-1, 0, 0};
  settings_.camera.tanHalfFov = 1.0f;
  EXPECT_EQ(compare(reader, environmentWithSun(1.0f)), 16u * 16u);
}

/// Against the closed form, not the oracle: a rectangle's moment is its solid angle times its mean direction.
TEST_F(OracleTest, ConstantLightIsExactInCosineBoxes) {
  Square square;
  square.atlasEdge = 32;
  const auto kernel = [](uint32_t, uint32_t record, uint32_t) { return cosineKernel(0, record, 2); };
  const auto reader = writeSynthetic(file("even.ptb"), square.makeAsset(), kernel);
  settings_.environmentDegrees = 123.4f;
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(2)), settings_);
  const auto shaded = renderer.readShaded();
  for (const auto& [r, glossy] : renderer.readVisible()) {
    const auto [box, amplitude] = unpackCosineBox(cosineKernel(0, r, 2));
    const double up = box.solidAngle() * meanDirection(box.u0, box.v0, box.du, box.dv).y / kPiDouble;
    const double share = box.du >= 1 && box.dv >= 1 ? 1.0 : std::max(up, 0.0), a = double(amplitude);
    const double tolerance = 2e-5 * std::abs(a) * std::max(share, 0.05);
    EXPECT_NEAR(double(shaded[2 * r].y), std::max(2 * a * share, 0.0), tolerance + 1e-9) << r;
  }
}

TEST_F(OracleTest, ConstantLightIsExactWhateverTheBox) {
  Square square;
  square.atlasEdge = 48;
  const auto reader = square.write(file("constant.ptb"), randomBox);
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(1, 2, 3)), settings_);
  const auto shaded = renderer.readShaded();
  const auto visible = renderer.readVisible();
  EXPECT_EQ(visible.size(), reader.asset().records.size());
  double worst = 0;
  for (const auto& [r, glossy] : visible) {
    const Rgb energy = unpackBox(packBox(randomBox(reader.asset().diffuseStream(), r, 0))).energy;
    worst = std::max(worst, error(shaded[2 * r], dvec3(energy) * dvec3(1, 2, 3)));
  }
  // Four prefixes rounded to half a unit of 2^-41 of the total, against a texel at the pole of 2^-24 of it.
  EXPECT_LT(worst, 2e-5);
  std::printf("worst relative difference %.2g\n", worst);
}

}  // namespace
}  // namespace boxlight
