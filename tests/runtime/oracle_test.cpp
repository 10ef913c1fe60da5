// SPDX-License-Identifier: Apache-2.0
// Equation 3 on the device against relight() in double precision, record by record.
#include <cmath>
#include <random>

#include "common/base/error.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "common/light/relight.h"
#include "runtime/light/fixed_point.h"
#include "shaders/shared.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

constexpr double kOracleTolerance = 1e-4;  // relative, of a record's radiance
// Of a record's radiance, divided by the least cosine: the device's sine and cosine have 2^-11.
constexpr double kGradientTolerance = 1e-2;
constexpr uint32_t kRadiances = gpu::kShadedRadiances, kGradients = gpu::kShadedGradients;
constexpr double kRoundedUnits =
    2;  // of the light table, in the integral over a box: four prefixes, half a unit each

constexpr double kMomentRounding = 5e-7;  // of the light of the whole sphere: floats of n . M

Image environmentWithSun(float sun) {
  Image map = makeImage(512, 256, 3);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (float& value : map.pixels) value = uniform(random) * uniform(random);
  for (int c = 0; c < 3; ++c) map.at(400, 60)[c] = sun;
  return map;
}

/// Where the centres of a slot's boxes lie in all views, within a fifth of a turn: centres that cancel each
/// other out on the circle have no mean, and floats say little about those that nearly do. One slot in twelve
/// lies at the seam.
float anchorOf(uint32_t record, uint32_t slot) {
  std::mt19937 random(record * 104729u + slot);
  return random() % 12 == 3 ? 0.0f : std::uniform_real_distribution<float>(0.0f, 1.0f)(random);
}

/// Sizes from less than a texel to the whole sphere, a quarter of them across the seam, at a pole or a full
/// ring.
Box randomBox(uint32_t stream, uint32_t record, uint32_t slot) {
  std::mt19937 random(stream * 7919u + record * 104729u + slot);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Box box;
  box.du = std::pow(2.0f, -12.0f * uniform(random));
  box.dv = std::pow(2.0f, -12.0f * uniform(random));
  box.u0 = anchorOf(record, slot) + 0.4f * (uniform(random) - 0.5f) - 0.5f * box.du;
  box.u0 -= std::floor(box.u0);
  box.v0 = uniform(random) * (1.0f - box.dv);
  switch (random() % 12) {
    case 0:
      box.du = 1.0f, box.u0 = 0.0f;
      break;
    case 1:
      box.v0 = 0.0f;
      break;
    case 2:
      box.v0 = 1.0f - box.dv;
      break;
    default:
      break;
  }
  if (random() % 16 != 0)
    box.energy = Rgb(uniform(random), uniform(random), uniform(random)) / float(slot + 1);
  return box;
}

/// The same slot of neighbouring views: a common box, slightly moved by each view.
Box matchedBox(uint32_t stream, uint32_t record, uint32_t slot) {
  const Box common = randomBox(0, record, slot), other = randomBox(stream, record, slot);
  Box box = common;
  box.u0 = common.u0 + 0.2f * (other.u0 - 0.5f);
  box.u0 -= std::floor(box.u0);
  box.dv = std::clamp(0.8f * common.dv + 0.2f * other.dv, 0.0f, 1.0f - box.v0);
  box.energy = 0.5f * (common.energy + other.energy);
  return box;
}

class OracleTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    settings_.camera = cameraAbove(64);
  }

  /// Returns the number of records compared.
  size_t compare(const asset::AssetReader& reader, const Image& environment) {
    gpu::FrameRenderer renderer(*device_, reader, environment, settings_);
    const SummedArea lights(makeLightMap(environment, settings_.lightSize));
    const double offset = environmentOffset(settings_.environmentDegrees);
    const auto shaded = renderer.readShaded();
    const auto visible = renderer.readVisible();
    const double unit = renderer.light().unit();
    Relighter relighter(reader);
    double worst = 0, worstGradient = 0;
    const uint32_t records = uint32_t(reader.asset().records.size());
    const auto gradientAt = [&](uint32_t r, uint32_t c) { return kRadiances * records + kGradients * r + c; };
    for (const auto& [r, glossy] : visible) {
      const TexelRadiance exact = relighter.relight(r, settings_.camera.eye, lights, offset,
                                                    settings_.interpolation, settings_.boxLimit);
      worst =
          std::max(worst, error(shaded[2 * r], exact.diffuse, rounding(relighter, reader.asset(), r, unit)));
      if (glossy && reader.asset().tiles.front().glossyBoxes > 0) {
        worst = std::max(worst, error(shaded[2 * r + 1], exact.glossy));
        EXPECT_NEAR(double(shaded[2 * r + 1].w), exact.hidden, 1e-5) << r;
      }
      if (isMapped_) {
        const dmat3 gradient = relighter.diffuse(r, lights, offset, settings_.boxLimit).gradient;
        for (uint32_t c = 0; c < kGradients; ++c)
          worstGradient = std::max(
              worstGradient, glm::length(dvec3(vec3(shaded[gradientAt(r, c)])) - gradient[c]) /
                                 std::max({glm::length(exact.diffuse), glm::length(gradient[c]), 1e-6}));
      }
    }
    EXPECT_LT(worstGradient, kGradientTolerance);
    EXPECT_LT(worst, tolerance_);
    RecordProperty("worst", std::to_string(worst));
    std::printf("worst relative difference %.2g over %zu records\n", worst, visible.size());
    return visible.size();
  }

  /// Relative, above what the rounding of the light table may do.
  static double error(vec4 device, dvec3 exact, double rounding = 0) {
    const double difference = glm::length(dvec3(vec3(device)) - exact);
    return std::max(difference - rounding, 0.0) / std::max(glm::length(exact), 1e-6);
  }

  /// Next to a bright sun a unit of the table is much to a dark texel at a pole.
  static double rounding(Relighter& relighter, const asset::Asset& asset, uint32_t record, double unit) {
    double sum = 0;
    for (const PackedBox& packed : relighter.kernel(asset.diffuseStream(), record))
      if (isCosineBox(packed))
        sum += std::abs(double(unpackCosineBox(packed).amplitude)) * kMomentRounding * std::ldexp(unit, 42);
      else
        sum += glm::length(dvec3(unpackBox(packed).weight())) * kRoundedUnits * unit;
    return sum;
  }

  gpu::FrameSettings settings_;
  bool isMapped_ = false;  // has the square a normal map?
  double tolerance_ = kOracleTolerance;
};

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

/// Slot 0 emits: nothing, little, or more than a half float holds; the boxes follow.
PackedBox emittingKernel(uint32_t stream, uint32_t record, uint32_t slot) {
  if (slot > 0) return packBox(matchedBox(stream, record, slot));
  std::mt19937 random(stream * 31u + record * 65537u);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  const float scale = record % 3 == 0 ? 0.0f : record % 3 == 1 ? 1.0f : 1e6f;
  return packEmission(scale * Rgb(uniform(random), uniform(random), uniform(random)));
}

TEST_F(OracleTest, EmittedRadianceDoesNotDependOnTheLight) {
  Square square;
  square.atlasEdge = 20;
  square.glossyBoxes = 4;
  square.diffuseBoxes = 3;
  square.extensions.resize(1);
  const auto reader = writeSynthetic(file("emit.ptb"), square.makeAsset(), emittingKernel);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  for (const Interpolation interpolation : {Interpolation::energy, Interpolation::weight}) {
    settings_.interpolation = interpolation;
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
  }
  settings_.boxLimit = 1;  // of the light; the emitted slot is always taken
  EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
  const Image dark = constantEnvironment({64, 32}, Rgb(0));
  gpu::FrameRenderer renderer(*device_, reader, dark, settings_);
  EXPECT_EQ(renderer.counts().boxes, 20u * 20u * 2);
  const auto shaded = renderer.readShaded();
  for (uint32_t r = 0; r < 400; ++r) {
    const Rgb emitted = unpackEmission(emittingKernel(reader.asset().diffuseStream(), r, 0));
    for (int c = 0; c < 3; ++c) ASSERT_FLOAT_EQ(shaded[2 * r][c], emitted[c]) << r;
  }
}

TEST_F(OracleTest, EmittedRadianceOfOneKindOfStreamAlone) {
  Square square;
  square.atlasEdge = 8;
  square.glossyBoxes = 2;
  square.extensions.resize(1);
  const asset::Asset asset = square.makeAsset();
  const auto kernel = [&](uint32_t stream, uint32_t record, uint32_t slot) {
    return stream == asset.diffuseStream() ? packBox(matchedBox(stream, record, slot))
           : slot == 0                     ? packEmission(Rgb(3, 2, 0.5f))
                                           : packBox(matchedBox(stream, record, slot));
  };
  const auto reader = writeSynthetic(file("gloss.ptb"), asset, kernel);
  EXPECT_EQ(compare(reader, environmentWithSun(1.0f)), 64u);
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(0)), settings_);
  EXPECT_EQ(renderer.counts().boxes, 64u * 2);
  const auto shaded = renderer.readShaded();
  for (const auto& [r, glossy] : renderer.readVisible()) {
    EXPECT_EQ(shaded[2 * r], vec4(0));
    EXPECT_NEAR(shaded[2 * r + 1].x, 3.0f, 1e-5f);  // whatever the view
  }
}

TEST_F(OracleTest, SplitLobesKeepEveryViewsHiddenPart) {
  Square square;
  square.atlasEdge = 20;
  square.visibility = [](uint32_t) { return VisibilityMap(); };
  square.extensions.resize(1);
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  for (const uint32_t emission : {0u, 1u}) {
    square.glossyBoxes = emission + 1 + 3;
    asset::Asset asset = square.makeAsset();
    for (uint32_t view = 0; view < asset.info.viewCount; view += 3)  // hide nothing of some records
      for (uint64_t tile = 0; tile < asset.tiles.size(); ++tile)
        asset.streamMasks[view * asset.tiles.size() + tile] &= 0xF0F0F0F0F0F0F0F0u;
    const auto kernel = [&](uint32_t stream, uint32_t record, uint32_t slot) {
      if (stream == asset.diffuseStream() || slot > emission) return packBox(randomBox(stream, record, slot));
      return slot == emission ? packHiddenPart(float(1 + (stream + record) % 9) / 16.0f)
                              : emittingKernel(stream, record, 0);
    };
    const auto reader = writeSynthetic(file("split.ptb"), asset, kernel);
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
    gpu::FrameRenderer renderer(*device_, reader, environmentWithSun(1.0f), settings_);
    EXPECT_EQ(renderer.counts().boxes, 20u * 20u * (1 + 3 * 3));
    settings_.boxLimit = 2;
    EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
    settings_.boxLimit = ~0u;
  }
}

TEST_F(OracleTest, RecordsReadTheViewsOfTheirOwnSpheres) {
  Square square;
  square.atlasEdge = 20;
  square.glossyBoxes = 4;
  square.viewFrequency = 4;
  settings_.camera.eye = {0.3f, 1.5f, 0.7f};
  settings_.camera.tanHalfFov = 1.5f;
  asset::Asset asset = square.makeAsset();
  asset.coarseViews = {{3, 92}, {2, 42}, {1, 12}};
  for (uint32_t r = 0; r < asset.records.size(); ++r)
    asset.records[r].flags |= r % 4 << asset::kCoarseViewShift;
  for (uint32_t view = 0; view < asset.info.viewCount; ++view)
    for (size_t tile = 0; tile < asset.tiles.size(); ++tile) {
      uint64_t& mask = asset.streamMasks[view * asset.tiles.size() + tile];
      mask = ~uint64_t(0) >> (64 - asset.tiles[tile].recordCount);
      for (uint32_t sphere = 1; sphere < 4; ++sphere)  // tiles begin at multiples of 64
        if (view >= asset.coarseViews[sphere - 1].count) mask &= ~(0x1111111111111111u << sphere);
    }
  const auto reader = writeSynthetic(file("spheres.ptb"), asset, [](uint32_t s, uint32_t r, uint32_t slot) {
    return packBox(randomBox(s, r, slot));
  });
  EXPECT_EQ(compare(reader, environmentWithSun(100.0f)), 20u * 20u);
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
