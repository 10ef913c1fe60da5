// SPDX-License-Identifier: Apache-2.0
#include "common/light/lobe_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "common/light/light_domain.h"
#include "common/light/lobe_boxes.h"

using namespace boxlight;

namespace {

constexpr uint32_t kColumns = VisibilityMap::kColumns, kRows = VisibilityMap::kRows;

template <class F>
VisibilityMap mapOf(F predicate) {
  VisibilityMap map;
  for (uint32_t y = 0; y < kRows; ++y)
    for (uint32_t x = 0; x < kColumns; ++x)
      if (predicate(x, y)) map.setVisible(x, y);
  return map;
}
VisibilityMap mapOfDirections(const std::function<bool(vec3)>& predicate) {
  return mapOf([&](uint32_t x, uint32_t y) {
    return predicate(uvToDirection((vec2(x, y) + 0.5f) / vec2(kColumns, kRows)));
  });
}
const VisibilityMap kOpen = mapOf([](uint32_t, uint32_t) { return true; });
const VisibilityMap kClosed;

std::vector<Box> lobeAt(vec3 normal, float cosine, float alpha, Rgb f0 = Rgb(1.0f)) {
  GgxLobe lobe;
  lobe.normal = glm::normalize(normal);
  orthonormalBasis(lobe.normal, lobe.tangent, lobe.bitangent);
  lobe.view = cosine * lobe.normal + std::sqrt(1 - cosine * cosine) * lobe.tangent;
  lobe.alpha = vec2(alpha);
  lobe.f0 = f0;
  const auto boxes = lobeBoxes(lobe);
  return {boxes.begin(), boxes.end()};
}
const vec3 kNormals[] = {{0, 1, 0}, {0, -1, 0}, {-1, 0, 1e-4f}, {0.3f, 0.9f, -0.4f}, {1, -0.2f, 0.7f}};

ClippedLobe clip(const std::vector<Box>& lobe, const VisibilityMap& map) {
  return clipLobe(lobe, {{&map}, {1.0f}});
}
ClippedLobe clip(const Box& box, const VisibilityMap& map) { return clip(std::vector{box}, map); }

double luminanceOf(const std::vector<Box>& lobe) {
  double sum = 0;
  for (const Box& box : lobe) sum += double(luminance(box.energy));
  return sum;
}
double direct(const ClippedLobe& clipped) {
  double sum = 0;
  for (const auto& [rectangle, energy] : clipped.pieces) sum += double(luminance(Rgb(energy)));
  return sum;
}

using Light = std::function<double(vec3)>;
double smooth(vec3 d) { return 1 + 0.8 * double(d.x) + 0.5 * double(d.z * d.y); }

/// Mean of the light over the rectangle, by midpoints.
double meanOf(const Light& light, const Rectangle& r, int side = 16) {
  double sum = 0, weights = 0;
  for (int i = 0; i < side * side; ++i) {
    const double u = r.u0 + r.du * (i % side + 0.5) / side, v = r.v0 + r.dv * (int(i / side) + 0.5) / side;
    const double weight = std::sin(kPiDouble * v);
    sum += weight * light(uvToDirection(vec2(float(u - std::floor(u)), float(v))));
    weights += weight;
  }
  return sum / weights;
}
double radiance(const ClippedLobe& clipped, const Light& light) {
  double sum = 0;
  for (const auto& [rectangle, energy] : clipped.pieces) sum += energy.x * meanOf(light, rectangle);
  return sum;
}

/// The visible part of a box, cell by cell.
double visiblePart(const Box& box, const VisibilityMap& map) {
  const double left = double(box.u0) * kColumns, right = left + double(box.du) * kColumns;
  const double top = double(box.v0) * kRows, bottom = top + double(box.dv) * kRows;
  double visible = 0;
  for (int y = int(top); y < std::min(int(std::ceil(bottom)), int(kRows)); ++y)
    for (int x = int(left); x < int(std::ceil(right)); ++x)
      if (map.isVisible(uint32_t(x) % kColumns, uint32_t(y)))
        visible += rectangleSolidAngle((std::min(right, x + 1.0) - std::max(left, double(x))) / kColumns,
                                       std::max(top, double(y)) / kRows, std::min(bottom, y + 1.0) / kRows);
  return visible / box.solidAngle();
}

}  // namespace

TEST(LobeClip, InTheOpenTheLobeStaysAsItIs) {
  for (const vec3 normal : kNormals)
    for (const float cosine : {0.1f, 0.9f}) {
      std::vector<Box> lobe = lobeAt(normal, cosine, 0.3f, {1, 0.5f, 0.1f});
      std::erase_if(lobe, [](const Box& box) { return box.energy == Rgb(0.0f); });
      const ClippedLobe clipped = clip(lobe, kOpen);
      ASSERT_EQ(clipped.pieces.size(), lobe.size());
      for (size_t j = 0; j < lobe.size(); ++j) {
        const auto& [rectangle, energy] = clipped.pieces[j];
        EXPECT_EQ(Rgb(energy), lobe[j].energy);
        EXPECT_EQ(rectangle.u0, double(lobe[j].u0));
        EXPECT_EQ(rectangle.v0, double(lobe[j].v0));
        EXPECT_EQ(rectangle.du, double(lobe[j].du));
        EXPECT_EQ(rectangle.dv, double(lobe[j].dv));
      }
      EXPECT_NEAR(clipped.hidden, 0, 1e-6);
    }
}

TEST(LobeClip, BehindAllAllIsHidden) {
  for (const vec3 normal : kNormals) {
    const std::vector<Box> lobe = lobeAt(normal, 0.6f, 0.3f, {1, 0.5f, 0.1f});
    const ClippedLobe clipped = clip(lobe, kClosed);
    EXPECT_TRUE(clipped.pieces.empty());
    EXPECT_NEAR(clipped.hidden, luminanceOf(lobe), 1e-6);
  }
}

TEST(LobeClip, PiecesAndTheHiddenPartAreTheLobe) {
  std::mt19937 random(1);
  for (const vec3 normal : kNormals)
    for (const uint32_t tenths : {1u, 5u, 9u}) {
      const VisibilityMap map = mapOf([&](uint32_t, uint32_t) { return random() % 10 < tenths; });
      const std::vector<Box> lobe = lobeAt(normal, 0.5f, 0.5f, {1, 0.5f, 0.1f});
      const ClippedLobe clipped = clip(lobe, map);
      EXPECT_NEAR(direct(clipped) + clipped.hidden, luminanceOf(lobe), 1e-6);
      EXPECT_NEAR(clipped.hidden, 1 - 0.1 * tenths, 0.15);
    }
}

TEST(LobeClip, OfABoxTheVisibleSolidAngleIsLeft) {
  std::mt19937 random(2);
  const auto fraction = [&] { return float(random() % 4096) / 4096; };
  for (int i = 0; i < 200; ++i) {
    const VisibilityMap map = mapOf([&](uint32_t, uint32_t) { return random() % 3 != 0; });
    Box box{fraction(), 0, 0.01f + 0.3f * fraction(), 0.01f + 0.09f * fraction(), Rgb(1.0f)};
    box.v0 = (1 - box.dv) * fraction();
    const ClippedLobe clipped = clip(box, map);
    EXPECT_NEAR(direct(clipped), visiblePart(box, map), 1e-3) << i;
    for (const auto& [rectangle, energy] : clipped.pieces) {
      EXPECT_GE(rectangle.u0, double(box.u0) - 1e-9);
      EXPECT_GE(rectangle.v0, double(box.v0) - 1e-9);
      EXPECT_LE(rectangle.u0 + rectangle.du, double(box.u0) + double(box.du) + 1e-9);
      EXPECT_LE(rectangle.v0 + rectangle.dv, double(box.v0) + double(box.dv) + 1e-9);
    }
  }
}

TEST(LobeClip, AHalfSpaceIsClippedAsTheIntegralSays) {
  for (const vec3 wall : {vec3(0, 0, 1), vec3(0.2f, 1, 0.1f), vec3(0.6f, -0.3f, 0.7f), vec3(-1, 0.1f, 0)})
    for (const vec3 normal : kNormals)
      for (const float alpha : {0.1f, 0.3f}) {
        const auto isOpen = [&](vec3 d) { return glm::dot(d, wall) > 0; };
        const Light acrossTheEdge = [&](vec3 d) { return 2.0 + 2.0 * double(glm::dot(d, wall)); };
        const std::vector<Box> lobe = lobeAt(normal, 0.7f, alpha);
        double light = 0, hidden = 0;
        for (const Box& box : lobe) {
          const auto seen = [&](vec3 d) { return isOpen(d) ? acrossTheEdge(d) : 0.0; };
          light += double(box.energy.x) * meanOf(seen, rectangleOf(box), 64);
          hidden += double(box.energy.x) *
                    meanOf([&](vec3 d) { return isOpen(d) ? 0.0 : 1.0; }, rectangleOf(box), 64);
        }
        const ClippedLobe clipped = clip(lobe, mapOfDirections(isOpen));
        EXPECT_NEAR(clipped.hidden, hidden, 0.025);
        EXPECT_NEAR(radiance(clipped, acrossTheEdge), light, 0.04);
      }
}

TEST(LobeClip, TwoMapsAreWeighted) {
  // 16 x 4 cells; of the left quarters one map sees the right half, the other all.
  const Box box{56.0f / 128, 30.0f / 64, 16.0f / 128, 4.0f / 64, Rgb(1.0f)};
  const VisibilityMap some = mapOf([](uint32_t x, uint32_t) { return x >= 60; });
  const ClippedLobe clipped = clipLobe(std::span(&box, 1), {{&some, &kOpen}, {0.25f, 0.75f}});
  ASSERT_EQ(clipped.pieces.size(), 4u);
  EXPECT_NEAR(clipped.hidden, 0.5 * 0.25 * 0.5, 1e-6);
  for (const size_t left : {0, 2}) {
    const auto& [rectangle, energy] = clipped.pieces[left];
    EXPECT_NEAR(energy.x, 0.25 * 0.875, 1e-3);
    EXPECT_NEAR(rectangle.u0 * 128, (0.25 * 0.5 * 60 + 0.75 * 56) / 0.875, 1e-6);
    EXPECT_NEAR(rectangle.du * 128, (0.25 * 0.5 * 4 + 0.75 * 8) / 0.875, 1e-6);
    EXPECT_NEAR(rectangle.v0 * 64, left == 0 ? 30 : 32, 1e-6);
    EXPECT_NEAR(rectangle.dv * 64, 2, 1e-6);
    EXPECT_NEAR(clipped.pieces[left + 1].rectangle.u0 * 128, 64, 1e-6);
    EXPECT_NEAR(clipped.pieces[left + 1].rectangle.du * 128, 8, 1e-6);
  }
}

TEST(LobeClip, IsContinuousInTheWeights) {
  const VisibilityMap a = mapOfDirections([](vec3 d) { return d.x > 0.1f; });
  const VisibilityMap b = mapOfDirections([](vec3 d) { return d.y + d.z > 0; });
  for (const vec3 normal : kNormals) {
    const std::vector<Box> lobe = lobeAt(normal, 0.7f, 0.3f);
    const auto at = [&](double w) { return clipLobe(lobe, {{&a, &b}, {float(w), float(1 - w)}}); };
    const ClippedLobe onlyA = clip(lobe, a), onlyB = clip(lobe, b);
    double last = radiance(onlyB, smooth);
    for (int i = 0; i <= 256; ++i) {
      const double w = i / 256.0;
      const ClippedLobe clipped = at(w);
      // Not exactly: a box that one map sees whole is quartered for the other's sake, and rows in between
      // count.
      EXPECT_NEAR(clipped.hidden, w * onlyA.hidden + (1 - w) * onlyB.hidden, 1e-3);
      EXPECT_NEAR(radiance(clipped, smooth), last, 0.015) << w;
      last = radiance(clipped, smooth);
    }
    EXPECT_NEAR(last, radiance(onlyA, smooth), 1e-6);
    EXPECT_NEAR(radiance(at(1e-6), smooth), radiance(onlyB, smooth), 1e-4);
  }
}

TEST(LobeClip, IsContinuousInThePlaceOfTheBox) {
  for (const bool upright : {true, false})
    for (const float height : {0.08f, 0.24f}) {  // of quarters of few rows and of more than are scanned
      const VisibilityMap map = mapOf([&](uint32_t x, uint32_t y) { return upright ? x < 50 : y < 30; });
      Box box{0.3f, 0.46f - height, 0.1f, height, Rgb(1.0f)};
      ClippedLobe last = clip(box, map);
      for (int i = 0; i < 12000; ++i) {
        (upright ? box.u0 : box.v0) += 1e-5f;
        const ClippedLobe next = clip(box, map);
        ASSERT_NEAR(next.hidden, last.hidden, 2e-4) << i;
        ASSERT_NEAR(radiance(next, smooth), radiance(last, smooth), 4e-4) << i;
        last = next;
      }
      EXPECT_GT(last.hidden, 0.4) << "it has passed the edge";
    }
}

TEST(LobeClip, TheSeamIsLikeAnyOtherPlace) {
  const auto isOpen = [](uint32_t x, uint32_t y) { return (x * 5 + y * 3) % 17 < 9; };
  const VisibilityMap map = mapOf(isOpen);
  const VisibilityMap turned = mapOf([&](uint32_t x, uint32_t y) { return isOpen((x + 64) % 128, y); });
  const Box box{115.5f / 128, 20.25f / 64, 0.25f, 0.1f, Rgb(1.0f)};
  Box moved = box;
  moved.u0 -= 0.5f;
  const ClippedLobe atSeam = clip(box, map), away = clip(moved, turned);
  EXPECT_NEAR(atSeam.hidden, away.hidden, 1e-9);
  ASSERT_EQ(atSeam.pieces.size(), away.pieces.size());
  for (size_t i = 0; i < away.pieces.size(); ++i) {
    EXPECT_NEAR(atSeam.pieces[i].rectangle.u0, away.pieces[i].rectangle.u0 + 0.5, 1e-9);
    EXPECT_NEAR(atSeam.pieces[i].rectangle.du, away.pieces[i].rectangle.du, 1e-9);
    EXPECT_NEAR(atSeam.pieces[i].energy.x, away.pieces[i].energy.x, 1e-9);
  }
  EXPECT_GT(atSeam.hidden, 0.2);
}

TEST(LobeClip, CapsAtThePolesAreClippedByTheirSolidAngle) {
  const VisibilityMap half = mapOf([](uint32_t x, uint32_t) { return x < 48; });
  const VisibilityMap ring = mapOf([](uint32_t, uint32_t y) { return y >= 2 && y < 62; });
  for (const float top : {0.0f, 60.0f / 64}) {
    const Box cap{0.3f, top, 1, 4.0f / 64, Rgb(1.0f)};
    EXPECT_NEAR(clip(cap, half).hidden, 80.0 / 128, 1e-6);
    const double closed = rectangleSolidAngle(1, 0, 2.0 / 64) / rectangleSolidAngle(1, 0, 4.0 / 64);
    EXPECT_NEAR(clip(cap, ring).hidden, closed, 1e-3);
    for (const auto& [rectangle, energy] : clip(cap, ring).pieces)
      EXPECT_NEAR(rectangle.v0 * 64, top > 0 ? 60 : 2, 1e-6);
  }
}

TEST(LobeClip, WhatIsHiddenIsReplacedByWhatIsStored) {
  const dvec3 stored = splitRadiance(dvec3(0.6, 0.3, 0.0), 0.25, 0.2 * dvec3(3, 2, 1), 0.2);
  EXPECT_NEAR(stored.x, 0.6 + 0.25 * 3, 0.03) << "the stored part's mean radiance, 3, fills the hidden part";
  EXPECT_NEAR(stored.y, 0.3 + 0.25 * 2, 0.03);
  EXPECT_NEAR(stored.z, 0.25 * 1, 0.01);
}

TEST(LobeClip, WhatIsHiddenAndNotStoredIsLikeTheRest) {
  EXPECT_NEAR(splitRadiance(dvec3(0.75), 0.25, dvec3(0.0), 0.0).x, 1.0, 1e-12);
  EXPECT_EQ(splitRadiance(dvec3(0.0), 1, dvec3(0.0), 0.0), dvec3(0.0)) << "nothing is known: no light";
}

TEST(LobeClip, AConstantLightStaysConstantWhateverIsHidden) {
  for (const double hidden : {0.0, 1e-6, 0.3, 0.999})
    for (const double part : {0.0, 1e-6, 0.3, 1.0})
      EXPECT_NEAR(splitRadiance(dvec3(7 * (1 - hidden)), hidden, dvec3(7 * part), part).x, 7.0, 1e-9);
}
