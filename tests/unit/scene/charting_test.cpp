// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/charting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "common/base/error.h"
#include "tests/support/meshes.h"
#include "tests/support/scenes.h"
#include "tests/unit/scene/atlas_check.h"

using namespace boxlight;

namespace {

struct Case {
  const char* name;
  void (*build)(Scene&);
  uint32_t atlas = 128;
};

void sphere(Scene& scene) {
  test::addSphere(scene, vec3(0), 1, 48);
  scene.hasTexcoord[0] = false;
}

void slivers(Scene& scene) {
  // A disc of thin wedges, and beside it needles that rounding to the atlas would leave no area.
  std::vector<vec3> positions = {vec3(0)};
  std::vector<uvec3> triangles;
  const uint32_t count = 1000;
  for (uint32_t i = 0; i < count; ++i) {
    const float a = 2 * kPi * float(i) / float(count);
    positions.emplace_back(std::cos(a), 0, -std::sin(a));
    triangles.emplace_back(0, i + 1, (i + 1) % count + 1);
  }
  for (int i = 0; i < 20; ++i) {
    const auto first = uint32_t(positions.size());
    const float z = 2 + 0.01f * float(i);
    positions.insert(positions.end(), {vec3(0, 0, z), vec3(1, 0, z), vec3(0.5f, 1e-9f, z)});
    triangles.emplace_back(first, first + 1, first + 2);
  }
  test::addMesh(scene, positions, triangles);
}

const Case kCases[] = {
    {"Cube", [](Scene& s) { test::addBox(s, vec3(-1), vec3(1)); }},
    {"ThinWall", [](Scene& s) { test::addBox(s, vec3(-1, -1, 0), vec3(1, 1, 1e-4f)); }},
    {"DoubleSidedLeaf",
     [](Scene& s) {
       s.materials[0].flags |= asset::kDoubleSided;
       test::addLeaves(s, 1, 1);
     }},
    {"LeafOfTwoSheets",
     [](Scene& s) {
       const std::vector<vec3> p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
       test::addMesh(s, p, {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}});
     }},
    {"TouchingBoxes",
     [](Scene& s) {
       test::addBox(s, vec3(-1), vec3(1));
       test::addBox(s, vec3(1, -1, -1), vec3(2, 1, 1));
       test::addBox(s, vec3(0, 1, 0), vec3(1, 2, 1));
     }},
    {"CoincidentTriangles",
     [](Scene& s) {
       for (int i = 0; i < 3; ++i) test::addBox(s, vec3(-1), vec3(1));
       test::addMesh(s, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}},
                     std::vector<vec3>(3, vec3(0, 0, 1)));
     }},
    {"Sphere", sphere},
    {"Torus", [](Scene& s) { test::addTorus(s, vec3(0), 1, 0.4f, 32); }},
    {"MoebiusStrip", [](Scene& s) { test::addMoebiusStrip(s, 64); }},
    {"Spiral", [](Scene& s) { test::addSpiral(s, 4, 40); }},
    {"Fan", [](Scene& s) { test::addFan(s, 5); }},
    {"FanOfMany", [](Scene& s) { test::addFan(s, 101); }},
    {"Slivers", slivers},
    {"SmallSphere",
     [](Scene& s) {
       sphere(s);
       test::place(s, 1e-4f, vec3(0));
     }},
    {"LargeTorus",
     [](Scene& s) {
       test::addTorus(s, vec3(0), 1, 0.4f, 32);
       test::place(s, 1e6f, vec3(0));
     }},
    {"FarSphere",
     [](Scene& s) {
       sphere(s);
       test::place(s, 1, vec3(1e5f, -1e5f, 1e5f));
     }},
    {"TexelsLargerThanTriangles", sphere, 16},
    {"TexelsSmallerThanTriangles", [](Scene& s) { test::addBox(s, vec3(-1), vec3(1)); }, 512},
    {"OneTexel", sphere, 1},
    {"MorePiecesThanTexels", [](Scene& s) { test::addLeaves(s, 1000, 0.05f); }, 16},
    {"AsManyPiecesAsTexels", [](Scene& s) { test::addLeaves(s, 1000, 0.05f); }, 32},
    {"OddAtlas", sphere, 77},
};

Scene build(const Case& c) {
  Scene scene = test::makeScene(test::lambert());
  c.build(scene);
  return scene;
}

std::vector<std::byte> bytesOf(const Scene& scene) {
  const auto vertices = std::as_bytes(std::span(scene.vertices));
  const auto triangles = std::as_bytes(std::span(scene.triangles));
  std::vector<std::byte> bytes(vertices.begin(), vertices.end());
  bytes.insert(bytes.end(), triangles.begin(), triangles.end());
  return bytes;
}

class AnyMesh : public testing::TestWithParam<Case> {
 protected:
  AnyMesh() : scene(build(GetParam())), before(scene) {
    charting = chartScene(scene, GetParam().atlas, ProgressStyle::none);
    map = makeTexels(scene, GetParam().atlas, GetParam().atlas);
  }
  Scene scene, before;
  Charting charting;
  TexelMap map;
};

}  // namespace

TEST_P(AnyMesh, KeepsItsSurface) {
  ASSERT_EQ(scene.triangles.size(), before.triangles.size());
  for (size_t t = 0; t < scene.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      asset::Vertex vertex = scene.vertices[scene.triangles[t].vertex[k]];
      const asset::Vertex& old = before.vertices[before.triangles[t].vertex[k]];
      for (const float uv : vertex.atlasUv) ASSERT_TRUE(uv >= 0 && uv <= 1) << uv;
      std::memcpy(vertex.atlasUv, old.atlasUv, sizeof(vertex.atlasUv));
      ASSERT_EQ(std::memcmp(&vertex, &old, sizeof(vertex)), 0);
    }
}

TEST_P(AnyMesh, OverlapsNowhereInTheAtlas) {
  const std::vector<uint32_t> pair = test::findOverlapInAtlas(scene);
  EXPECT_TRUE(pair.empty()) << pair[0] << " and " << pair[1];
}

TEST_P(AnyMesh, EveryTriangleHasItsAreaInTexels) { EXPECT_LE(test::footprintError(scene, map), 1e-3); }

TEST_P(AnyMesh, TexelDensityIsEvenWithinTwo) {
  const test::Stretch stretch = test::measureStretch(scene, GetParam().atlas);
  EXPECT_LE(stretch.most, 2 * stretch.least);
  EXPECT_LE(stretch.leftOut, 1e-4);
  EXPECT_LE(stretch.most, charting.texelsPerMetre * (1 + 1e-2));
}

TEST_P(AnyMesh, FiltersNeverLeaveTheirChart) {
  ASSERT_GE(charting.gutter, 2u);
  for (uint32_t coarser = 1; coarser <= charting.gutter / 2; coarser *= 2)
    EXPECT_EQ(test::countLeaks(scene, map, charting.crumb, coarser), 0u) << coarser << " times coarser";
}

TEST_P(AnyMesh, SameBytesTwice) {
  Scene again = before;
  chartScene(again, GetParam().atlas, ProgressStyle::none);
  EXPECT_EQ(bytesOf(scene), bytesOf(again));
}

/// Charts are as few as the shape lets them be: a chart a face, a turn, a sheet; a sphere needs six of 55
/// degrees.
TEST(Charting, TakesFewCharts) {
  const std::map<std::string, uint32_t> most = {
      {"Cube", 6},           {"ThinWall", 6}, {"DoubleSidedLeaf", 1}, {"LeafOfTwoSheets", 2},
      {"TouchingBoxes", 18}, {"Sphere", 20},  {"Torus", 20},          {"MoebiusStrip", 6},
      {"Spiral", 8},         {"Fan", 5},      {"Slivers", 21}};
  for (const Case& c : kCases) {
    if (!most.contains(c.name)) continue;
    Scene scene = build(c);
    EXPECT_LE(chartScene(scene, c.atlas, ProgressStyle::none).charts, most.at(c.name)) << c.name;
  }
}

TEST(Charting, TexelScaleMakesTexelsDenser) {
  Scene scene = test::makeScene(test::lambert());
  test::addBox(scene, vec3(-1), vec3(1));
  const auto second = uint32_t(scene.triangles.size());
  test::addBox(scene, vec3(2), vec3(4));
  scene.texelScales = {{second, 3.0f}};
  chartScene(scene, 256, ProgressStyle::none);
  const auto density = [&scene](uint32_t t) {
    const asset::Vertex& a = scene.vertices[scene.triangles[t].vertex[0]];
    const asset::Vertex& b = scene.vertices[scene.triangles[t].vertex[1]];
    return std::hypot(a.atlasUv[0] - b.atlasUv[0], a.atlasUv[1] - b.atlasUv[1]) * 256 / 2;
  };
  EXPECT_NEAR(density(second) / density(0), 3, 1e-3);
}

/// In a process of its own: the signal is remembered for good.
TEST(ChartingDeathTest, EndsAfterAnInterrupt) {
  Scene scene = test::makeScene(test::lambert());
  test::addTorus(scene, vec3(0), 1, 0.4f, 64);
  const auto chart = [&scene] {
    catchInterrupts();
    std::raise(SIGINT);
    try {
      chartScene(scene, 64, ProgressStyle::none);
    } catch (const Error& error) {
      std::_Exit(int(error.code()));
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(chart(), testing::ExitedWithCode(int(ExitCode::interrupted)), "");
}

INSTANTIATE_TEST_SUITE_P(Charting, AnyMesh, testing::ValuesIn(kCases),
                         [](const auto& c) { return c.param.name; });
