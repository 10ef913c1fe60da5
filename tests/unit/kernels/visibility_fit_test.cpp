// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/visibility_fit.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "bake/transport/warp.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// Cosine-distributed directions, stratified, of which `isSeen` tells whether they go straight.
std::vector<FirstDirection> directions(vec3 normal, uint32_t edge, const std::function<bool(vec3)>& isSeen) {
  vec3 tangent, bitangent;
  orthonormalBasis(normal, tangent, bitangent);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<FirstDirection> result;
  for (uint32_t i = 0; i < edge * edge; ++i) {
    const vec2 at((float(i % edge) + uniform(random)) / float(edge),
                  (float(i / edge) + uniform(random)) / float(edge));
    const vec3 local = cosineDirection(at), d = local.x * tangent + local.y * bitangent + local.z * normal;
    result.push_back({d, isSeen(d)});
  }
  return result;
}

std::vector<CosineBox> fit(const std::vector<FirstDirection>& first, vec3 normal, int boxes = 20) {
  return VisibilityFitter({.boxes = boxes}).fit(first, normal);
}

/// What the boxes return under a constant light.
double energyOf(const std::vector<CosineBox>& boxes, vec3 normal) {
  double sum = 0;
  for (const auto& [box, amplitude] : boxes) {
    const double cosine = glm::dot(dvec3(normal), meanDirection(box.u0, box.v0, box.du, box.dv));
    const bool whole = box.du >= 1 && box.dv >= 1;
    sum += double(amplitude) * (whole ? 1.0 : std::max(box.solidAngle() * cosine / kPiDouble, 0.0));
  }
  return sum;
}

double straightPart(const std::vector<FirstDirection>& first) {
  return double(std::count_if(first.begin(), first.end(), [](const auto& d) { return d.straight; })) /
         double(first.size());
}

/// Root mean square of visible minus boxes, cosine-weighted.
double errorOf(const std::vector<CosineBox>& boxes, const std::vector<FirstDirection>& first) {
  double sum = 0;
  for (const auto& [towards, straight] : first) {
    const vec2 uv = directionToUv(towards);
    double value = 0;
    for (const auto& [box, amplitude] : boxes) {
      const float u = uv.x - box.u0 - std::floor(uv.x - box.u0);
      if (u < box.du && uv.y >= box.v0 && uv.y < box.v0 + box.dv) value += double(amplitude);
    }
    sum += (value - double(straight)) * (value - double(straight));
  }
  return std::sqrt(sum / double(first.size()));
}

constexpr double kHalfFloats = 5e-4;
const vec3 kTilted = glm::normalize(vec3(0.4f, 0.7f, -0.5f));

TEST(VisibilityFit, InTheOpenOneBoxIsAll) {
  for (const vec3 n : {vec3(0, 1, 0), vec3(1, 0, 0), kTilted}) {
    const auto boxes = fit(directions(n, 64, [](vec3) { return true; }), n);
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(boxes[0].isWhole());
    EXPECT_EQ(boxes[0].amplitude, 1.0f);
  }
}

TEST(VisibilityFit, WhereNoLightArrivesThereIsNone) {
  EXPECT_TRUE(fit(directions(kTilted, 16, [](vec3) { return false; }), kTilted).empty());
  EXPECT_TRUE(fit({}, kTilted).empty());
}

TEST(VisibilityFit, AWallAndItsOpposite) {
  const vec3 n(0, 1, 0);
  for (const float side : {-1.0f, 1.0f}) {
    const auto first = directions(n, 128, [&](vec3 d) { return side * d.x > 0; });
    const auto boxes = fit(first, n);
    EXPECT_LE(boxes.size(), 4u);
    EXPECT_LT(errorOf(boxes, first), 0.08) << "the wall's edge lies on the raster";
    EXPECT_NEAR(energyOf(boxes, n), straightPart(first), kHalfFloats);
  }
}

TEST(VisibilityFit, BoxesOverTheSeamAndInAnyNumber) {
  const auto seen = [](vec3 d) { return !(d.x < -0.5f && std::abs(d.z) < 0.4f && d.y < 0.6f) || d.y > 0.5f; };
  const auto first = directions(kTilted, 128, seen);
  double before = 1;
  for (const int count : {1, 2, 4, 8, 20}) {
    const auto boxes = fit(first, kTilted, count);
    EXPECT_LE(boxes.size(), size_t(count));
    const double error = errorOf(boxes, first);
    EXPECT_LE(error, before + 1e-3) << count;
    EXPECT_NEAR(energyOf(boxes, kTilted), straightPart(first), kHalfFloats);
    before = error;
  }
  EXPECT_LT(before, 0.12);
}

/// An opening that 1 path in 1000 finds.
TEST(VisibilityFit, AKeyholeKeepsItsEnergy) {
  const vec3 hole = glm::normalize(vec3(0.5f, 0.8f, 0.1f));
  const auto first = directions(kTilted, 128, [&](vec3 d) { return glm::dot(d, hole) > 0.9995f; });
  ASSERT_GT(straightPart(first), 0);
  const auto boxes = fit(first, kTilted);
  EXPECT_NEAR(energyOf(boxes, kTilted), straightPart(first), kHalfFloats);
  double far = 0;
  for (const auto& [box, amplitude] : boxes)
    if (box.du >= 1) far += std::abs(double(amplitude));
  EXPECT_LT(far, 1e-3);
}

TEST(VisibilityFit, FewPathsOfAllKindsAreFinite) {
  for (const uint32_t edge : {1u, 2u, 3u})
    for (const int which : {0, 1, 2}) {
      uint32_t i = 0;
      const auto first =
          directions(kTilted, edge, [&](vec3) { return which == 0 || (i++ % 3) == 0 || which == 2; });
      for (const auto& [box, amplitude] : fit(first, kTilted)) EXPECT_TRUE(std::isfinite(amplitude));
    }
  std::vector<FirstDirection> same(100, {kTilted, true}), below(100, {-kTilted, true});
  for (size_t i = 0; i < 50; ++i) same[i].straight = below[i].straight = false;
  for (const auto& first : {same, below})
    for (const auto& [box, amplitude] : fit(first, kTilted)) EXPECT_TRUE(std::isfinite(amplitude));
}

/// What the boxes beside the whole sphere take away together, in a direction.
double takenAway(const std::vector<CosineBox>& boxes, vec2 uv) {
  double sum = 0;
  for (const CosineBox& box : boxes) {
    const double u = double(uv.x) - double(box.box.u0), v = double(uv.y) - double(box.box.v0);
    if (!box.isWhole() && u - std::floor(u) < double(box.box.du) && v >= 0 && v < double(box.box.dv))
      sum += double(box.amplitude);
  }
  return sum;
}

/// Else a sun that is hidden would be taken away twice. Walls and tilted slats, on the horizon where least
/// squares sees little of them.
TEST(VisibilityFit, NoDirectionIsTakenAwayTwice) {
  for (const float tilt : {0.0f, 0.4f, 0.8f, 1.2f}) {
    const vec3 across = glm::normalize(vec3(std::cos(tilt), 0.6f * std::sin(tilt), std::sin(tilt)));
    const auto first = directions(kTilted, 128, [&](vec3 d) {
      const float height = glm::dot(d, kTilted), slat = std::sin(9 * glm::dot(d, across));
      return height > 0.25f + 0.3f * slat;
    });
    ASSERT_GT(straightPart(first), 0.8) << "where boxes take away";
    const auto boxes = fit(first, kTilted);
    ASSERT_GT(boxes.size(), 4u);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 128; ++x) {
        const double taken = takenAway(boxes, {(float(x) + 0.5f) / 128, (float(y) + 0.5f) / 64});
        ASSERT_GT(taken, -1.01) << "tilt " << tilt << " at " << x << ' ' << y;
        ASSERT_LT(taken, 0.01) << "tilt " << tilt << " at " << x << ' ' << y;
      }
  }
}

TEST(VisibilityFit, EdgesLieOnTheRasterOfTheFormat) {
  const auto first = directions(kTilted, 64, [](vec3 d) { return d.x + 0.3f * d.z > 0.1f; });
  for (const CosineBox& box : fit(first, kTilted)) {
    const PackedBox packed = packCosineBox(box);
    EXPECT_EQ(packed.v0 % kCosineRaster, 0u);
    EXPECT_EQ((packed.v0 + packed.dv + 1u) % kCosineRaster, 0u);
    const CosineBox back = unpackCosineBox(packed);
    EXPECT_EQ(back.box.u0, box.box.u0);
    EXPECT_EQ(back.box.du, box.box.du);
    EXPECT_NEAR(back.amplitude, box.amplitude, 1e-3 * std::abs(double(box.amplitude)));
  }
}

}  // namespace
}  // namespace boxlight
