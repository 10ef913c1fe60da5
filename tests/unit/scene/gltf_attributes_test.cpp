// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_builder.h"

namespace boxlight::test {
namespace {

using Floats = std::vector<float>;

// All positions of a scene, triangle by triangle.
std::vector<vec3> corners(const Scene& scene) {
  std::vector<vec3> result;
  for (const asset::Triangle& t : scene.triangles) {
    for (const uint32_t v : t.vertex) {
      const float* p = scene.vertices[v].position;
      result.emplace_back(p[0], p[1], p[2]);
    }
  }
  return result;
}

// Five points in zigzag, and the triangles that a mode makes of them, as indices.
std::vector<vec3> cornersOf(int mode, bool indexed) {
  GltfBuilder builder;
  const Floats points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
  Json primitive = {{"attributes", {{"POSITION", builder.addFloats("VEC3", points)}}}, {"mode", mode}};
  if (indexed) primitive["indices"] = builder.addIndices<uint16_t>({0, 1, 2, 3, 4});
  builder.addMesh(primitive);
  return corners(builder.load());
}

std::vector<vec3> points(const std::vector<int>& indices) {
  const vec3 all[5] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  std::vector<vec3> result;
  for (const int i : indices) result.push_back(all[i]);
  return result;
}

TEST(GltfPrimitives, StripsAndFansKeepTheirFront) {
  EXPECT_EQ(cornersOf(5, false), points({0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(cornersOf(5, true), points({0, 1, 2, 1, 3, 2, 2, 3, 4}));
  // The last triangle of the fan, (0,0) (1,1) (0,2), is no line; (0,0) (0,1) (0,2) would be one.
  EXPECT_EQ(cornersOf(6, false), points({1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

template <class T>
void expectIndexedQuad() {
  GltfBuilder builder;
  const Floats quad = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9};
  builder.addMesh({{"attributes", {{"POSITION", builder.addFloats("VEC3", quad)}}},
                   {"indices", builder.addIndices<T>({0, 1, 2, 2, 1, 3})}});
  const Scene scene = builder.load();
  EXPECT_EQ(corners(scene), points({0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(scene.boundsMax, vec3(1, 1, 0)) << "a vertex that no triangle uses must not count";
}

TEST(GltfPrimitives, IndexTypes) {
  expectIndexedQuad<uint8_t>();
  expectIndexedQuad<uint16_t>();
  expectIndexedQuad<uint32_t>();
}

TEST(GltfPrimitives, PointsAndLinesAreSkipped) {
  GltfBuilder builder = oneTriangle();
  for (const int mode : {0, 1, 2, 3}) {
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
  }
  EXPECT_EQ(builder.load().triangles.size(), 1u);
}

TEST(GltfPrimitives, TrianglesWithoutAreaAreDropped) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["indices"] = builder.addIndices<uint8_t>({0, 0, 1, 0, 1, 2, 1, 1, 1});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.triangles.size(), 1u);
  EXPECT_EQ(scene.vertices.size(), 3u);
}

TEST(GltfAccessors, InterleavedWithOffsets) {
  GltfBuilder builder;
  const Floats data = {7, 0, 0, 0, .25f, .5f, 7, 1, 0, 0, .5f, .5f, 7, 0, 1, 0, .75f, .5f};
  const int view = builder.addView(bytesOf(data), 24);
  builder.addMesh({{"attributes",
                    {{"POSITION", builder.addAccessor(view, 5126, "VEC3", 3, {{"byteOffset", 4}})},
                     {"TEXCOORD_0", builder.addAccessor(view, 5126, "VEC2", 3, {{"byteOffset", 16}})}}}});
  const Scene scene = builder.load();
  EXPECT_EQ(corners(scene), points({0, 1, 2}));
  EXPECT_EQ(scene.vertices[2].uv[0][0], .75f);
  EXPECT_TRUE(scene.hasTexcoord[0]);
  EXPECT_FALSE(scene.hasTexcoord[1]);
}

TEST(GltfAccessors, StrideZeroMeansTightlyPacked) {
  GltfBuilder builder = oneTriangle();
  builder.json["bufferViews"][0]["byteStride"] = 0;
  EXPECT_EQ(corners(builder.load()), points({0, 1, 2}));
}

Json sparse(GltfBuilder& builder, const std::vector<uint8_t>& indices, const Floats& values) {
  const int indexView = builder.addView(bytesOf(indices)), valueView = builder.addView(bytesOf(values));
  return {{"sparse",
           {{"count", indices.size()},
            {"indices", {{"bufferView", indexView}, {"componentType", 5121}}},
            {"values", {{"bufferView", valueView}}}}}};
}

TEST(GltfAccessors, SparseOverABufferView) {
  GltfBuilder builder = oneTriangle();
  builder.json["accessors"][0].update(sparse(builder, {0, 2}, {0, 0, 1, 0, 3, 1}));
  EXPECT_EQ(corners(builder.load()), (std::vector<vec3>{{0, 0, 1}, {1, 0, 0}, {0, 3, 1}}));
}

TEST(GltfAccessors, SparseOverZeros) {
  GltfBuilder builder;
  const Json more = sparse(builder, {1, 2}, {1, 0, 0, 0, 1, 0});
  builder.addMesh({{"attributes", {{"POSITION", builder.addAccessor(-1, 5126, "VEC3", 3, more)}}}});
  EXPECT_EQ(corners(builder.load()), points({0, 1, 2}));
}

TEST(GltfAccessors, SparseIndicesOverZeros) {
  GltfBuilder builder = oneTriangle();
  Json more = sparse(builder, {1, 2}, {});
  more["sparse"]["values"]["bufferView"] = builder.addView({1, 2});
  builder.json["bufferViews"].erase(2);  // the empty view of the values that were not used
  more["sparse"]["values"]["bufferView"] = 2;
  builder.primitive()["indices"] = builder.addAccessor(-1, 5121, "SCALAR", 3, more);
  EXPECT_EQ(corners(builder.load()), points({0, 1, 2}));
}

TEST(GltfAccessors, NormalizedIntegers) {
  GltfBuilder builder = oneTriangle();
  Json& attributes = builder.primitive()["attributes"];
  const std::vector<uint16_t> uv = {0, 65535, 32768, 13107, 65535, 0};
  attributes["TEXCOORD_0"] =
      builder.addAccessor(builder.addView(bytesOf(uv)), 5123, "VEC2", 3, {{"normalized", true}});
  attributes["TEXCOORD_1"] =
      builder.addAccessor(builder.addView({0, 255, 0, 0, 51, 102, 0, 0, 255, 0, 0, 0}, 4), 5121, "VEC2", 3,
                          {{"normalized", true}});
  attributes["COLOR_0"] = builder.addAccessor(builder.addView({255, 0, 51, 102, 0, 0, 0, 0, 0, 0, 0, 255}),
                                              5121, "VEC4", 3, {{"normalized", true}});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.vertices[0].uv[0][1], 1.0f);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv[0][0], 32768 / 65535.0f);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv[0][1], .2f);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv[1][0], .2f);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv[1][1], .4f);
  EXPECT_EQ(scene.vertices[0].color[0], 1.0f);
  EXPECT_FLOAT_EQ(scene.vertices[0].color[2], .2f);
  EXPECT_FLOAT_EQ(scene.vertices[0].color[3], .4f);
  EXPECT_EQ(scene.vertices[2].color[3], 1.0f);
  EXPECT_TRUE(scene.hasTexcoord[0] && scene.hasTexcoord[1]);
}

TEST(GltfAccessors, QuantizedMeshes) {
  GltfBuilder builder;
  builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::vector<int16_t> positions = {0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0};
  const std::vector<int8_t> normals = {0, 0, 127, 0, 0, 0, -128, 0, 127, 0, 0, 0};
  builder.addMesh(
      {{"attributes",
        {{"POSITION", builder.addAccessor(builder.addView(bytesOf(positions), 8), 5122, "VEC3", 3)},
         {"NORMAL", builder.addAccessor(builder.addView(bytesOf(normals), 4), 5120, "VEC3", 3,
                                        {{"normalized", true}})}}}});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.boundsMax, vec3(2, 2, 0));
  EXPECT_EQ(scene.vertices[0].normal[2], 1.0f);
  EXPECT_EQ(scene.vertices[1].normal[2], -1.0f);
}

TEST(GltfAttributes, ColorsOfThreeComponentsAreOpaque) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["attributes"]["COLOR_0"] =
      builder.addFloats("VEC3", {.1f, .2f, .3f, 4, -1, 0, 0, 0, 0});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.vertices[0].color[1], .2f);
  EXPECT_EQ(scene.vertices[0].color[3], 1.0f);
  EXPECT_EQ(scene.vertices[1].color[0], 1.0f) << "clamped";
  EXPECT_EQ(scene.vertices[1].color[1], 0.0f) << "clamped";
}

TEST(GltfAttributes, FlatNormalsWhereThereAreNone) {
  GltfBuilder builder;
  // Two faces that share an edge at a right angle.
  const int position = builder.addFloats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  builder.addMesh(
      {{"attributes", {{"POSITION", position}, {"TANGENT", builder.addFloats("VEC4", Floats(16, 1.0f))}}},
       {"indices", builder.addIndices<uint8_t>({0, 1, 2, 0, 2, 3})}});
  const Scene scene = builder.load();
  ASSERT_EQ(scene.vertices.size(), 6u);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(scene.vertices[scene.triangles[0].vertex[c]].normal[2], 1.0f);
    EXPECT_EQ(scene.vertices[scene.triangles[1].vertex[c]].normal[0], 1.0f);
  }
  EXPECT_EQ(scene.vertices[0].tangent[2], 0.0f) << "TANGENT without NORMAL must be ignored";
}

TEST(GltfAttributes, ZeroNormalsBecomeTheFaces) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["attributes"]["NORMAL"] = builder.addFloats("VEC3", {0, 0, 0, 3, 0, 4, 0, 0, 0});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.vertices[0].normal[2], 1.0f);
  EXPECT_FLOAT_EQ(scene.vertices[1].normal[0], .6f) << "normals are made unit";
  EXPECT_EQ(scene.vertices[2].normal[2], 1.0f);
}

TEST(GltfAttributes, FramesAreOrthonormal) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["attributes"]["NORMAL"] = builder.addFloats("VEC3", {0, 0, 1, 1, 2, 3, -1, 0, 1});
  // The first is parallel to its normal and cannot be used; the second is not perpendicular.
  builder.primitive()["attributes"]["TANGENT"] =
      builder.addFloats("VEC4", {0, 0, 1, 1, 1, 0, 0, -1, 0, 1, 0, 1});
  for (const asset::Vertex& v : builder.load().vertices) {
    const vec3 n(v.normal[0], v.normal[1], v.normal[2]), t(v.tangent[0], v.tangent[1], v.tangent[2]);
    EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(t), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(n, t), 0.0f, 1e-6f);
    EXPECT_EQ(std::abs(v.tangent[3]), 1.0f);
  }
}

}  // namespace
}  // namespace boxlight::test
