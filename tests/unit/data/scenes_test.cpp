// SPDX-License-Identifier: Apache-2.0
#include "data/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bake/scene/atlas.h"
#include "bake/scene/gltf_load.h"
#include "common/base/error.h"
#include "common/base/file.h"
#include "tests/support/temporary_path.h"

namespace boxlight::data {
namespace {

std::vector<const Chart*> chartsOf(const Model& model) {
  std::vector<const Chart*> charts;
  for (const Part& part : model.parts)
    for (const Chart& chart : part.charts) charts.push_back(&chart);
  return charts;
}

/// Which chart (from 1) covers the centre of each sample; -1 where two triangles do.
std::vector<int> rasterise(const Model& model, int resolution) {
  std::vector<int> owner(size_t(resolution) * resolution, 0);
  int id = 0;
  for (const Chart* chart : chartsOf(model)) {
    ++id;
    for (size_t i = 0; i < chart->indices.size(); i += 3) {
      glm::dvec2 p[3];
      for (int k = 0; k < 3; ++k) p[k] = glm::dvec2(chart->atlas[chart->indices[i + k]]) * double(resolution);
      auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
      if (cross(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
      const glm::dvec2 low = glm::min(p[0], glm::min(p[1], p[2])),
                       high = glm::max(p[0], glm::max(p[1], p[2]));
      for (int y = std::max(0, int(low.y)); y <= std::min(resolution - 1, int(high.y)); ++y)
        for (int x = std::max(0, int(low.x)); x <= std::min(resolution - 1, int(high.x)); ++x) {
          const glm::dvec2 centre(x + 0.5, y + 0.5);
          bool inside = true;
          for (int k = 0; k < 3; ++k) inside &= cross(p[(k + 1) % 3] - p[k], centre - p[k]) > 1e-7;
          int& cell = owner[size_t(y) * resolution + x];
          if (inside) cell = cell == 0 ? id : -1;
        }
    }
  }
  return owner;
}

double atlasArea(const Chart& chart) {
  double area = 0;
  for (size_t i = 0; i < chart.indices.size(); i += 3) {
    const vec2 a = chart.atlas[chart.indices[i]], b = chart.atlas[chart.indices[i + 1]],
               c = chart.atlas[chart.indices[i + 2]];
    area += 0.5 * std::abs(double(b.x - a.x) * double(c.y - a.y) - double(b.y - a.y) * double(c.x - a.x));
  }
  return area;
}

double teapotArea(const Model& model) {
  double area = 0;
  for (const Chart& chart : model.parts[0].charts) area += surfaceArea(chart);
  return area;
}

class EveryScene : public testing::TestWithParam<std::string> {};

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneRecipe& recipe : sceneRecipes()) names.push_back(recipe.name);
  return names;
}

TEST_P(EveryScene, AtlasIsUniqueInsideAndHasGutters) {
  const Model model = makeScene(GetParam());
  for (const Chart* chart : chartsOf(model))
    for (vec2 uv : chart->atlas) {
      ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
    }
  const int perTexel = 8, resolution = 128 * perTexel;
  const std::vector<int> owner = rasterise(model, resolution);
  for (int cell : owner) ASSERT_NE(cell, -1) << "two triangles on one sample";
  // Two free texels of a 128 x 128 atlas between charts: no other chart right or below within 2 * 8 samples.
  for (int y = 0; y < resolution; ++y)
    for (int x = 0; x < resolution; ++x) {
      const int here = owner[size_t(y) * resolution + x];
      if (here == 0) continue;
      for (int step = 1; step <= 2 * perTexel; ++step) {
        const int right = x + step < resolution ? owner[size_t(y) * resolution + x + step] : 0;
        const int below = y + step < resolution ? owner[size_t(y + step) * resolution + x] : 0;
        ASSERT_TRUE(right == 0 || right == here);
        ASSERT_TRUE(below == 0 || below == here);
      }
    }
}

TEST_P(EveryScene, NormalsFaceAsTheTriangles) {
  const Model model = makeScene(GetParam());
  for (const Chart* chart : chartsOf(model))
    for (size_t i = 0; i < chart->indices.size(); i += 3) {
      const uint32_t* t = &chart->indices[i];
      const vec3 a = chart->positions[t[0]], b = chart->positions[t[1]], c = chart->positions[t[2]];
      for (int k = 0; k < 3; ++k)
        ASSERT_GT(glm::dot(glm::normalize(glm::cross(b - a, c - a)), chart->normals[t[k]]), 0.5f);
    }
}

/// The bake's own reader takes the file whole, and its own check accepts the atlas.
TEST_P(EveryScene, LoadsWithAnAtlas) {
  const auto path = test::temporaryPath(GetParam() + "-load.glb");
  const Model model = makeScene(GetParam());
  writeGlb(path, model);
  Scene scene = loadGltf(path);
  std::filesystem::remove(path);
  size_t indices = 0;
  for (const Chart* chart : chartsOf(model)) indices += chart->indices.size();
  EXPECT_EQ(scene.triangles.size(), indices / 3);
  EXPECT_EQ(scene.materials.size(), model.parts.size());
  EXPECT_EQ(scene.textures.size(), model.textures.size());
  EXPECT_EQ(chooseAtlas(scene, {}).uvSet, model.textured ? 1u : 0u);
}

TEST_P(EveryScene, SameBytesTwice) {
  const auto path = test::temporaryPath(GetParam() + ".glb");
  writeGlb(path, makeScene(GetParam()));
  const std::vector<std::byte> first = readFile(path);
  writeGlb(path, makeScene(GetParam()));
  EXPECT_EQ(first, readFile(path));
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return scene.param; });

TEST(Scenes, AreasAreClosedForm) {
  auto area = [](const char* name, size_t part = 0) {
    double sum = 0;
    const Model model = makeScene(name);
    for (const Chart& chart : model.parts[part].charts) sum += surfaceArea(chart);
    return sum;
  };
  EXPECT_NEAR(area("sphere"), 4 * kPiDouble, 0.02);  // the chords of 96 x 48 steps lose .1 %
  EXPECT_NEAR(area("bowl"), 2 * kPiDouble, 0.01);
  EXPECT_NEAR(area("plane"), 4, 1e-6);
  EXPECT_NEAR(area("plane_wall", 0), 0.2, 1e-6);
  EXPECT_NEAR(area("plane_wall", 1), 8e6, 1);
  EXPECT_NEAR(area("textured_box"), 6, 1e-5);
  EXPECT_NEAR(area("masked_leaf"), 1.6 * std::sqrt(0.6 * 0.6 + 1.4 * 1.4), 1e-5);
}

TEST(Scenes, SphereFacesOut) {
  const Model model = makeScene("sphere");
  EXPECT_NEAR(signedVolume(model.parts[0].charts[0]), 4.0 / 3.0 * kPiDouble, 0.02);
}

/// Texels per square metre of the teapot's charts are alike, but for the bottom, which it stands on; the slab
/// takes its share of the atlas, not more.
TEST(Scenes, DemoSpreadsItsTexels) {
  const Model model = makeScene("teapot");
  double teapot = 0, slab = 0, total = 0, most = 0;
  for (const Part& part : model.parts)
    for (const Chart& chart : part.charts) {
      total += atlasArea(chart);
      if (part.name == "teapot") teapot += atlasArea(chart), most = std::max(most, surfaceArea(chart));
      if (part.name == "slab") slab += atlasArea(chart);
    }
  EXPECT_GT(total, 0.65);
  EXPECT_GT(slab, 0.12);
  EXPECT_LT(slab, 0.22);
  EXPECT_GT(teapot, 0.4);
  int sparse = 0;
  for (const Chart& chart : model.parts[0].charts) {
    if (surfaceArea(chart) < 0.02 * most) continue;  // whole texels round small charts
    const double density = atlasArea(chart) / surfaceArea(chart) / (teapot / teapotArea(model));
    if (density < 0.2)
      ++sparse;
    else
      EXPECT_NEAR(density, 1.15, 0.25);
  }
  EXPECT_EQ(sparse, 1);
}

TEST(Scenes, ParametersReachTheMaterial) {
  EXPECT_FLOAT_EQ(makeScene("ggx_sphere", {{"roughness", 0.3}}).parts[0].material.roughness, 0.3f);
  EXPECT_THROW(makeScene("ggx_sphere", {{"colour", 1}}), Error);
  EXPECT_THROW(makeScene("no_such_scene"), Error);
}

/// What the header of a GLB and glTF's schema demand of what we write.
TEST(Scenes, GlbIsWellFormed) {
  const auto path = test::temporaryPath("well-formed.glb");
  writeGlb(path, makeScene("textured_box"));
  const std::vector<std::byte> bytes = readFile(path);
  std::filesystem::remove(path);
  uint32_t header[5];
  std::memcpy(header, bytes.data(), sizeof(header));
  EXPECT_EQ(header[0], 0x46546C67u);
  EXPECT_EQ(header[2], bytes.size());
  EXPECT_EQ(header[3] % 4, 0u);
  const auto* text = reinterpret_cast<const char*>(bytes.data()) + 20;
  const auto json = nlohmann::json::parse(text, text + header[3]);
  const size_t binarySize = bytes.size() - 28 - header[3];
  EXPECT_EQ(json["buffers"][0]["byteLength"], binarySize);
  for (const auto& view : json["bufferViews"])
    EXPECT_LE(view["byteOffset"].get<size_t>() + view["byteLength"].get<size_t>(), binarySize);
  EXPECT_EQ(json["textures"].size(), 2u);
  EXPECT_TRUE(json["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_1"));
}

}  // namespace
}  // namespace boxlight::data
