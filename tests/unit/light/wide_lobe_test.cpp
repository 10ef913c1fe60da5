// SPDX-License-Identifier: Apache-2.0
#include "common/light/wide_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/light/ggx.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"

using namespace boxlight;

namespace {

using Radiance = std::function<Rgb(vec3)>;

Image mapOf(const Radiance& radiance) {
  Image map = makeImage(256, 128, 3);
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x) {
      const Rgb value = radiance(uvToDirection((vec2(x, y) + 0.5f) / vec2(map.width, map.height)));
      std::copy_n(&value[0], 3, map.at(x, y));
    }
  return map;
}

VisibilityMap visibleWhere(const std::function<bool(vec3)>& predicate) {
  VisibilityMap map;
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x)
      if (predicate(uvToDirection((vec2(x, y) + 0.5f) / vec2(VisibilityMap::kColumns, VisibilityMap::kRows))))
        map.setVisible(x, y);
  return map;
}
const VisibilityMap kOpen = visibleWhere([](vec3) { return true; });

GgxLobe lobeAt(vec3 normal, float cosine, float alpha) {
  GgxLobe lobe;
  lobe.normal = glm::normalize(normal);
  orthonormalBasis(lobe.normal, lobe.tangent, lobe.bitangent);
  lobe.view = cosine * lobe.normal + std::sqrt(1 - cosine * cosine) * lobe.tangent;
  lobe.alpha = vec2(alpha);
  lobe.f0 = {0.9f, 0.6f, 0.3f};
  return lobe;
}

/// The lobe times n.w, per steradian.
dvec3 reflectance(const GgxLobe& lobe, vec3 direction) {
  const auto local = [&](vec3 d) {
    return vec3(glm::dot(d, lobe.tangent), glm::dot(d, lobe.bitangent), glm::dot(d, lobe.normal));
  };
  const vec3 light = local(direction), view = local(lobe.view);
  if (!(light.z > 0)) return dvec3(0.0);
  const vec3 half = glm::normalize(light + view);
  const Rgb fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * ggx::schlickWeight(glm::dot(view, half));
  return dvec3(fresnel *
               (ggx::distribution(half, lobe.alpha) * ggx::visibility(light, view, lobe.alpha) * light.z));
}

/// By quadrature: radiance over what the whole lobe reflects, and the hidden part of that.
SeenLobe truth(const GgxLobe& lobe, const std::function<bool(vec3)>& visible, const Radiance& radiance) {
  constexpr int kRows = 384;  // three for each of the map
  dvec3 all(0.0), direct(0.0), light(0.0);
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < 2 * kRows; ++x) {
      const double v = (y + 0.5) / kRows, omega = std::pow(kPiDouble / kRows, 2) * std::sin(kPiDouble * v);
      const vec3 direction = uvToDirection({(float(x) + 0.5f) / (2 * kRows), float(v)});
      const dvec3 energy = omega * reflectance(lobe, direction);
      all += energy;
      if (!visible(direction)) continue;
      direct += energy, light += energy * dvec3(radiance(direction));
    }
  return {light / all, 1 - double(luminance(Rgb(direct / all)))};
}

const vec3 kNormals[] = {{0, 1, 0}, {-1, 0, 1e-4f}, {0.3f, 0.9f, -0.4f}, {1, -0.2f, 0.7f}};
constexpr float kAlphas[] = {0.02f, 0.05f, 0.15f, 0.4f, 1.0f}, kCosines[] = {0.08f, 0.3f, 0.7f, 1.0f};

/// Behind one map.
SeenLobe seen(const GgxLobe& lobe, const VisibilityMap& map, const LightMoments& light, double uOffset = 0) {
  const FilteredVisibility visibility{{&map}, {1.0f}};
  return seeByCells(lobe, VisibleCells(visibility, uOffset), light, uOffset);
}

void forLobes(const std::function<void(const GgxLobe&)>& test) {
  for (const vec3 normal : kNormals)
    for (const float alpha : kAlphas)
      for (const float cosine : kCosines) {
        SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", n.v " << cosine);
        test(lobeAt(normal, cosine, alpha));
      }
}

}  // namespace

TEST(WideLobe, AConstantLightReturnsWhatIsNotHidden) {
  const LightMoments light(mapOf([](vec3) { return Rgb(1, 2, 3); }));
  const VisibilityMap half = visibleWhere([](vec3 d) { return d.x > 0.1f; });
  forLobes([&](const GgxLobe& lobe) {
    const SeenLobe open = seen(lobe, kOpen, light), some = seen(lobe, half, light);
    EXPECT_LT(glm::length(open.radiance - dvec3(1, 2, 3)), 3e-5);
    EXPECT_LT(open.hidden, 1e-9);
    EXPECT_GT(some.hidden, 0.0);
    EXPECT_NEAR(some.radiance.y / 2, 1 - some.hidden, 0.03);  // channels differ by Fresnel's colour
  });
}

TEST(WideLobe, ASunCountsWhereItStands) {
  const Radiance sky = [](vec3 d) {
    return dot(d, glm::normalize(vec3(0.5f, 0.6f, -0.3f))) > 0.9995f ? Rgb(3000, 2500, 2000)
                                                                     : Rgb(0.5f + 0.3f * d.y);
  };
  const Image map = mapOf(sky);
  const LightMoments light(map);
  const Radiance drawn = [&](vec3 d) {
    const vec2 at = directionToUv(d) * vec2(map.width, map.height);
    return rgbAt(map, std::min(uint32_t(at.x), map.width - 1), std::min(uint32_t(at.y), map.height - 1));
  };
  const auto open = [](vec3) { return true; };
  forLobes([&](const GgxLobe& lobe) {
    const dvec3 expected = truth(lobe, open, drawn).radiance;
    const dvec3 found = seen(lobe, kOpen, light).radiance;
    EXPECT_LT(glm::length(found - expected), 0.06 * glm::length(expected) + 0.02);
  });
}

TEST(WideLobe, WhatIsHiddenIsLeftOut) {
  const Radiance sky = [](vec3 d) { return Rgb(1 + 0.5f * d.x, 1 - 0.4f * d.z, 1 + 0.8f * d.y); };
  const auto visible = [](vec3 d) { return d.x + 0.5f * d.z > -0.2f; };
  const LightMoments light(mapOf(sky));
  const VisibilityMap map = visibleWhere(visible);
  forLobes([&](const GgxLobe& lobe) {
    const SeenLobe expected = truth(lobe, visible, sky), found = seen(lobe, map, light);
    EXPECT_NEAR(found.hidden, expected.hidden, 0.04);
    EXPECT_LT(glm::length(found.radiance - expected.radiance), 0.06);
  });
}

TEST(WideLobe, ASunBehindAWallIsHidden) {
  const vec3 sun = glm::normalize(vec3(0.5f, 0.6f, -0.3f));
  const LightMoments light(mapOf([&](vec3 d) { return dot(d, sun) > 0.9995f ? Rgb(3000) : Rgb(0.0f); }));
  const VisibilityMap wall = visibleWhere([&](vec3 d) { return dot(d, sun) < 0.98f; });  // of 11 degrees
  const GgxLobe lobe = lobeAt({0, 1, 0}, 0.7f, 0.5f);
  EXPECT_GT(seen(lobe, kOpen, light).radiance.x, 0.5);
  EXPECT_LT(seen(lobe, wall, light).radiance.x, 1e-6);
  EXPECT_LT(seen(lobe, wall, light).hidden, 0.1);
}

TEST(WideLobe, TurnsWithTheLight) {
  const Radiance sky = [](vec3 d) {
    return dot(d, vec3(0.6f, 0.6f, 0.5f)) > 0.97f ? Rgb(50) : Rgb(1 + 0.5f * d.x);
  };
  constexpr float kTurn = 0.25f;  // a whole number of cells
  const Image map = mapOf(sky);
  Image turned = map;
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x)
      std::copy_n(map.at((x + map.width / 4) % map.width, y), 3, turned.at(x, y));
  const VisibilityMap half = visibleWhere([](vec3 d) { return d.x > 0.1f; });
  forLobes([&](const GgxLobe& lobe) {
    const SeenLobe a = seen(lobe, half, LightMoments(map), double(kTurn));
    const SeenLobe b = seen(lobe, half, LightMoments(turned));
    EXPECT_LT(glm::length(a.radiance - b.radiance), 1e-5);
    EXPECT_LT(glm::length(a.towards - b.towards), 1e-5);
    EXPECT_NEAR(a.hidden, b.hidden, 1e-6);
  });
}

TEST(WideLobe, AStreakIsFollowedWhereItRuns) {
  // A lamp that the streak of brushed metal passes at a distance of a few times its width.
  for (const float turn : {0.0f, 0.8f, 1.6f, 2.4f})
    for (const float beside : {0.0f, 2.0f, 6.0f}) {
      GgxLobe lobe = lobeAt({0.2f, 0.1f, 1}, 0.7f, 0.1f);
      lobe.alpha = {0.6f, 0.04f};
      const vec3 along = std::cos(turn) * lobe.tangent + std::sin(turn) * lobe.bitangent;
      lobe.bitangent = glm::cross(lobe.normal, along);
      lobe.tangent = along;
      const vec3 half = glm::normalize(lobe.normal + 0.15f * along + beside * 0.04f * lobe.bitangent);
      const vec3 lamp = 2 * dot(lobe.view, half) * half - lobe.view;
      const Radiance light = [&](vec3 d) { return Rgb(dot(d, lamp) > 0.995f ? 30.0f : 0.1f); };
      const dvec3 expected = truth(
                                 lobe, [](vec3) { return true; }, light)
                                 .radiance;
      const dvec3 found = seen(lobe, kOpen, LightMoments(mapOf(light))).radiance;
      EXPECT_LT(glm::length(found - expected), 0.08 * glm::length(expected)) << turn << ' ' << beside;
    }
}

TEST(WideLobe, TakesOverFromBoxesByDegrees) {
  constexpr float kCosine = 0.5f, kStep = 2e-5f;
  const SummedArea light(mapOf([](vec3 d) { return Rgb(1 + 0.9f * d.x); }));
  const FilteredVisibility open{{&kOpen}, {1.0f}};
  const auto lobe = [&](float width) { return lobeAt({0.3f, 0.9f, -0.4f}, kCosine, width / kCosine); };
  const auto at = [&](float width) { return seeLobe(lobe(width), open, light).radiance.x; };
  for (float width = 0.9f * kWideFrom; width < 1.2f * kWideTo; width += kStep)
    EXPECT_NEAR(at(width), at(width + kStep), 2e-3) << width;
  const GgxLobe narrow = lobe(0.999f * kWideFrom), wide = lobe(1.001f * kWideTo);
  EXPECT_EQ(seeLobe(narrow, open, light).radiance, seeByBoxes(narrow, open, light).radiance);
  EXPECT_EQ(seeLobe(wide, open, light).radiance,
            seeByCells(wide, VisibleCells(open), light.moments()).radiance);
}

TEST(WideLobe, LittleChangesWhereCellsGiveWayToSmallerOnes) {
  // Under a sun and a lamp, as the view turns in steps of a tenth of a degree.
  const LightMoments light(mapOf([](vec3 d) {
    return Rgb(0.5f + (dot(d, glm::normalize(vec3(0.5f, 0.6f, -0.3f))) > 0.9995f ? 2000.0f : 0.0f) +
               (dot(d, glm::normalize(vec3(-0.5f, 0.3f, 0.4f))) > 0.95f ? 10.0f : 0.0f));
  }));
  const VisibleCells open(FilteredVisibility{{&kOpen}, {1.0f}});
  for (const float alpha : {0.03f, 0.1f, 0.3f}) {
    const double width = 2 * double(alpha);
    double before = -1;
    for (float turn = -1.2f; turn < 1.2f; turn += 0.00175f) {
      GgxLobe lobe = lobeAt({0.1f, 1, 0.2f}, std::cos(turn), alpha);
      if (turn < 0) lobe.view -= 2 * dot(lobe.view, lobe.tangent) * lobe.tangent;
      const double value = seeByCells(lobe, open, light).radiance.y;
      // By no more than a lobe of that width can turn away from a small light, and two per cent.
      const double last = before > 0 ? before : value;
      EXPECT_NEAR(value / last, 1, 0.02 + 4 * 0.0035 / width) << alpha << " at " << turn;
      before = value;
    }
  }
}
