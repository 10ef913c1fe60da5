// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"
#include "gltf_builder.h"

namespace boxlight::test {
namespace {

vec3 positionAt(const Scene& scene, size_t triangle, int corner) {
  const float* p = scene.vertices[scene.triangles[triangle].vertex[corner]].position;
  return {p[0], p[1], p[2]};
}

void expectNear(vec3 a, vec3 b) {
  EXPECT_LT(glm::length(a - b), 1e-6f)
      << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

const double kHalf = std::sqrt(0.5);

TEST(GltfNodes, TranslationRotationScaleInThatOrder) {
  GltfBuilder builder = oneTriangle();
  Json& node = builder.json["nodes"][0];
  node["translation"] = {10, 20, 30};
  node["rotation"] = {0, 0, kHalf, kHalf};  // 90 degrees about +Z
  node["scale"] = {2, 3, 4};
  const Scene scene = builder.load();
  expectNear(positionAt(scene, 0, 0), {10, 20, 30});
  expectNear(positionAt(scene, 0, 1), {10, 22, 30});
  expectNear(positionAt(scene, 0, 2), {7, 20, 30});
}

TEST(GltfNodes, MatricesAreColumnMajorAndMultiplyDownTheTree) {
  GltfBuilder builder = oneTriangle();
  builder.json["nodes"][0] = {{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}};
  const int parent =
      builder.add("nodes", {{"children", {0}}, {"translation", {100, 0, 0}}, {"scale", {2, 2, 2}}});
  builder.json["scenes"][0]["nodes"] = {parent};
  const Scene scene = builder.load();
  expectNear(positionAt(scene, 0, 0), {110, 12, 14});
  expectNear(positionAt(scene, 0, 1), {110, 14, 14});
}

TEST(GltfNodes, MeshIsShownByEveryNodeInDepthFirstOrder) {
  GltfBuilder builder = oneTriangle();
  builder.json["nodes"] = {{{"children", {1, 3}}, {"translation", {1, 0, 0}}},
                           {{"children", {2}}, {"mesh", 0}},
                           {{"mesh", 0}, {"translation", {10, 0, 0}}},
                           {{"mesh", 0}, {"translation", {20, 0, 0}}}};
  builder.json["scenes"][0]["nodes"] = {0};
  const Scene scene = builder.load();
  ASSERT_EQ(scene.triangles.size(), 3u);
  for (size_t t = 0; t < 3; ++t) expectNear(positionAt(scene, t, 0), {1.0f + 10.0f * float(t), 0, 0});
}

TEST(GltfNodes, WhichSceneIsShown) {
  GltfBuilder builder = oneTriangle();
  builder.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 5}}});
  builder.add("scenes", {{"nodes", {1}}});
  builder.json["scene"] = 1;
  expectNear(positionAt(builder.load(), 0, 0), {0, 0, 5});
  builder.json.erase("scene");
  expectNear(positionAt(builder.load(), 0, 0), {0, 0, 0});
  builder.json.erase("scenes");
  builder.json["nodes"][0]["children"] = {1};
  EXPECT_EQ(builder.load().triangles.size(), 2u);
}

TEST(GltfNodes, MirrorTurnsWindingNormalAndTangentSign) {
  GltfBuilder builder = texturedSquare(Json::object());
  builder.primitive()["attributes"]["TANGENT"] =
      builder.addFloats("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  builder.json["nodes"][0]["scale"] = {-1, 1, 1};
  const Scene scene = builder.load();
  const vec3 a = positionAt(scene, 0, 0), b = positionAt(scene, 0, 1), c = positionAt(scene, 0, 2);
  expectNear(glm::normalize(glm::cross(b - a, c - a)), {0, 0, 1});
  const asset::Vertex& v = scene.vertices[0];
  expectNear({v.normal[0], v.normal[1], v.normal[2]}, {0, 0, 1});
  expectNear({v.tangent[0], v.tangent[1], v.tangent[2]}, {-1, 0, 0});
  EXPECT_EQ(v.tangent[3], -1.0f);
}

TEST(GltfNodes, NormalsStayPerpendicularUnderUnevenScale) {
  GltfBuilder builder;
  // The plane x + y = 1, given with its normal.
  const int normal = builder.addFloats("VEC3", {1, 1, 0, 1, 1, 0, 1, 1, 0});
  builder.addMesh(
      {{"attributes",
        {{"POSITION", builder.addFloats("VEC3", {1, 0, 0, 0, 1, 0, 0, 1, 1})}, {"NORMAL", normal}}}});
  builder.json["nodes"][0]["scale"] = {4, 1, -2};
  const Scene scene = builder.load();
  const vec3 a = positionAt(scene, 0, 0), b = positionAt(scene, 0, 1), c = positionAt(scene, 0, 2);
  const float* n = scene.vertices[0].normal;
  expectNear({n[0], n[1], n[2]}, glm::normalize(vec3(1, 4, 0)));
  expectNear(glm::normalize(glm::cross(b - a, c - a)), glm::normalize(vec3(1, 4, 0)));
}

TEST(GltfNodes, DeepTreesDoNotNeedStack) {
  GltfBuilder builder = oneTriangle();
  Json nodes = Json::array({Json::object()});
  for (int i = 1; i <= 50000; ++i) nodes[size_t(i - 1)]["children"] = {i}, nodes.push_back(Json::object());
  nodes[50000]["mesh"] = 0;
  builder.json["nodes"] = nodes;
  EXPECT_EQ(builder.load().triangles.size(), 1u);
}

TEST(GltfNodes, TexelScaleIsInherited) {
  GltfBuilder builder = oneTriangle();
  const Json scaled = {{"boxlight_texel_scale", 3}};
  builder.json["nodes"] = {{{"mesh", 0}},
                           {{"children", {2, 3}}, {"extras", scaled}},
                           {{"mesh", 0}},
                           {{"mesh", 0}, {"extras", {{"boxlight_texel_scale", 0.5}}}},
                           {{"mesh", 0}, {"extras", "not an object"}}};
  builder.json["scenes"][0]["nodes"] = {0, 1, 4};
  EXPECT_EQ(texelScaleOfTriangles(builder.load()), (std::vector<float>{1, 3, 0.5f, 1}));
}

TEST(GltfNodes, TexelScaleIsChecked) {
  for (const Json& value :
       {Json(0), Json(-1), Json(1000), Json("2"), Json(nullptr), Json(Json::array({1}))}) {
    GltfBuilder builder = oneTriangle();
    builder.json["nodes"][0]["extras"]["boxlight_texel_scale"] = value;
    try {
      builder.load();
      ADD_FAILURE() << value;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalidInput);
      EXPECT_NE(std::string(error.what()).find("nodes[0].extras.boxlight_texel_scale"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace boxlight::test
