// SPDX-License-Identifier: Apache-2.0
#pragma once

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

inline constexpr double kOracleTolerance = 1e-4;  // relative, of a record's radiance
// Of a record's radiance, divided by the least cosine: the device's sine and cosine have 2^-11.
inline constexpr double kGradientTolerance = 1e-2;
inline constexpr uint32_t kRadiances = gpu::kShadedRadiances, kGradients = gpu::kShadedGradients;
inline constexpr double kRoundedUnits =
    2;  // of the light table, in the integral over a box: four prefixes, half a unit each

inline constexpr double kMomentRounding = 5e-7;  // of the light of the whole sphere: floats of n . M

inline Image environmentWithSun(float sun) {
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
inline float anchorOf(uint32_t record, uint32_t slot) {
  std::mt19937 random(record * 104729u + slot);
  return random() % 12 == 3 ? 0.0f : std::uniform_real_distribution<float>(0.0f, 1.0f)(random);
}

/// Sizes from less than a texel to the whole sphere, a quarter of them across the seam, at a pole or a full
/// ring.
inline Box randomBox(uint32_t stream, uint32_t record, uint32_t slot) {
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
inline Box matchedBox(uint32_t stream, uint32_t record, uint32_t slot) {
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

}  // namespace boxlight
