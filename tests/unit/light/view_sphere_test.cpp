// SPDX-License-Identifier: Apache-2.0
#include "common/light/view_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boxlight {
namespace {

vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

float degreesBetween(vec3 a, vec3 b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)) * 180.0f / kPi;
}

TEST(ViewSphere, CountsOfEveryFrequency) {
  for (uint32_t f = 1; f <= 6; ++f) {
    const ViewSphere sphere(f);
    EXPECT_EQ(sphere.viewCount(), 10 * f * f + 2);
    EXPECT_EQ(sphere.triangles().size(), 20 * f * f);
  }
}

TEST(ViewSphere, NinetyTwoViews) {
  const ViewSphere sphere(3);
  EXPECT_EQ(sphere.viewCount(), 92u);
  EXPECT_EQ(sphere.triangles().size(), 180u);
  vec3 sum(0.0f);
  for (const vec3& d : sphere.directions()) {
    EXPECT_NEAR(glm::length(d), 1.0f, 1e-6f);
    sum += d;
  }
  EXPECT_LT(glm::length(sum), 1e-4f);
  for (const uvec3& t : sphere.triangles())
    for (int k = 0; k < 3; ++k) {
      const float edge = degreesBetween(sphere.directions()[t[k]], sphere.directions()[t[(k + 1) % 3]]);
      EXPECT_GT(edge, 20.0f);
      EXPECT_LT(edge, 24.0f);
    }
}

TEST(ViewSphere, TrianglesAreCounterClockwiseAndNeighboursShareTheEdge) {
  const ViewSphere sphere(3);
  for (uint32_t t = 0; t < sphere.triangles().size(); ++t) {
    const uvec3 triangle = sphere.triangles()[t];
    const vec3 a = sphere.directions()[triangle.x], b = sphere.directions()[triangle.y],
               c = sphere.directions()[triangle.z];
    EXPECT_GT(glm::dot(a, glm::cross(b, c)), 0.0f);
    for (int k = 0; k < 3; ++k) {
      const uvec3 other = sphere.triangles()[sphere.neighbours()[t][k]];
      int shared = 0;
      for (int i = 0; i < 3; ++i) {
        EXPECT_NE(other[i], triangle[k]) << "the corner opposite to the edge is not shared";
        shared += other[i] == triangle[(k + 1) % 3] || other[i] == triangle[(k + 2) % 3];
      }
      EXPECT_EQ(shared, 2);
    }
  }
}

TEST(ViewSphere, AdjacencyIsSymmetricAndSixfold) {
  const ViewSphere sphere(3);
  int fivefold = 0;
  for (uint32_t v = 0; v < sphere.viewCount(); ++v) {
    const auto& around = sphere.adjacent(v);
    fivefold += around.size() == 5;
    EXPECT_TRUE(around.size() == 5 || around.size() == 6);
    EXPECT_TRUE(std::is_sorted(around.begin(), around.end()));
    for (const uint32_t w : around) {
      const auto& back = sphere.adjacent(w);
      EXPECT_TRUE(std::find(back.begin(), back.end(), v) != back.end());
    }
  }
  EXPECT_EQ(fivefold, 12);
}

TEST(ViewSphere, LocateFindsTheTriangleFromAnyStart) {
  std::mt19937 random(1);
  for (const uint32_t frequency : {1u, 3u, 6u}) {
    const ViewSphere sphere(frequency);
    for (int i = 0; i < 2000; ++i) {
      const vec3 d = randomDirection(random);
      const ViewBlend blend = sphere.locate(d, uint32_t(random() % sphere.triangles().size()));
      EXPECT_NEAR(blend.weight.x + blend.weight.y + blend.weight.z, 1.0f, 1e-6f);
      vec3 point(0.0f);
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(blend.weight[k], 0.0f);
        EXPECT_EQ(blend.view[k], sphere.triangles()[blend.triangle][k]);
        point += blend.weight[k] * sphere.directions()[blend.view[k]];
      }
      EXPECT_LT(glm::length(glm::normalize(point) - d), 3e-6f);
    }
  }
}

TEST(ViewSphere, ACornerIsItself) {
  const ViewSphere sphere(3);
  for (uint32_t v = 0; v < sphere.viewCount(); ++v) {
    const ViewBlend blend = sphere.locate(sphere.directions()[v]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(blend.weight[k], blend.view[k] == v ? 1.0f : 0.0f, 1e-5f);
  }
}

TEST(ViewSphere, BlendIsContinuousAcrossEdges) {
  const ViewSphere sphere(3);
  std::mt19937 random(2);
  std::vector<float> value(sphere.viewCount());
  for (float& v : value) v = std::uniform_real_distribution<float>()(random);
  auto blended = [&](vec3 d) {
    const ViewBlend blend = sphere.locate(d);
    float sum = 0.0f;
    for (int k = 0; k < 3; ++k) sum += blend.weight[k] * value[blend.view[k]];
    return sum;
  };
  const vec3 axis = randomDirection(random);
  vec3 x, y;
  orthonormalBasis(axis, x, y);
  constexpr int kSteps = 20000;  // a step of .018 degrees changes a weight by about .001
  float last = blended(x);
  for (int i = 1; i <= kSteps; ++i) {
    const float angle = 2.0f * kPi * float(i) / float(kSteps);
    const float now = blended(std::cos(angle) * x + std::sin(angle) * y);
    EXPECT_LT(std::abs(now - last), 0.003f) << i;
    last = now;
  }
}

TEST(ViewSphere, AboutSixtyThreeViewsOfAHemisphere) {
  const ViewSphere sphere(3);
  std::mt19937 random(3);
  double mean = 0.0;
  constexpr int kNormals = 500;
  for (int i = 0; i < kNormals; ++i) {
    const vec3 normal = randomDirection(random);
    const std::vector<bool> needed = viewsOfHemisphere(sphere, normal);
    mean += double(std::count(needed.begin(), needed.end(), true)) / kNormals;
    for (int j = 0; j < 20; ++j) {
      const vec3 view = randomDirection(random);
      if (glm::dot(view, normal) <= 0.0f) continue;
      for (const uint32_t v : sphere.locate(view).view)
        EXPECT_TRUE(needed[v]) << "a view above the horizon has all three corners";
    }
  }
  EXPECT_NEAR(mean, 63.0, 2.0);
}

TEST(Horizon, DirectionsAreRaisedToTheCosine) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const vec3 normal = randomDirection(random), d = randomDirection(random);
    const vec3 raised = raiseAboveHorizon(d, normal);
    EXPECT_NEAR(glm::length(raised), 1.0f, 1e-6f);
    if (glm::dot(d, normal) >= kHorizonCosine) {
      EXPECT_EQ(raised, d);
    } else {
      EXPECT_NEAR(glm::dot(raised, normal), kHorizonCosine, 5e-6f);
      EXPECT_NEAR(glm::dot(glm::cross(normal, d), raised), 0.0f, 1e-6f)
          << "stays in the plane of d and the normal";
      EXPECT_GT(glm::dot(raised, d - glm::dot(d, normal) * normal), 0.0f) << "and on the side of d";
    }
  }
  const vec3 fromBehind = raiseAboveHorizon({0, -1, 0}, {0, 1, 0});
  EXPECT_NEAR(fromBehind.y, kHorizonCosine, 1e-6f);
  EXPECT_NEAR(glm::length(fromBehind), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace boxlight
