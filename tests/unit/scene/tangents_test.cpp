// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/tangents.h"

#include <gtest/gtest.h>

#include "gltf_builder.h"

namespace boxlight::test {
namespace {

const Json kNormalMapped = {{"normalTexture", {{"index", 0}}}};
const Bytes kFlatMap = png(1, 1, {128, 128, 255, 255});

void expectTangent(const asset::Vertex& v, vec3 direction, float sign) {
  EXPECT_LT(glm::length(vec3(tangentOf(v)) - direction), 1e-6f)
      << v.tangent[0] << ' ' << v.tangent[1] << ' ' << v.tangent[2];
  EXPECT_EQ(v.tangent[3], sign);
}

// The bitangent must point up in the image, which is +Y here.
TEST(Tangents, UprightImage) {
  GltfBuilder builder = texturedSquare(kNormalMapped);
  builder.addTexture(kFlatMap);
  const Scene scene = builder.load();
  EXPECT_EQ(scene.vertices.size(), 4u);
  for (const asset::Vertex& v : scene.vertices) expectTangent(v, {1, 0, 0}, 1);
}

TEST(Tangents, MirroredAndTurnedImages) {
  GltfBuilder mirrored = texturedSquare(kNormalMapped);
  mirrored.addTexture(kFlatMap);
  mirrored.primitive()["attributes"]["TEXCOORD_0"] = mirrored.addFloats("VEC2", {1, 1, 0, 1, 0, 0, 1, 0});
  for (const asset::Vertex& v : mirrored.load().vertices) expectTangent(v, {-1, 0, 0}, -1);

  // The image's right is +Y, its up -X.
  GltfBuilder turned = texturedSquare(kNormalMapped);
  turned.addTexture(kFlatMap);
  turned.primitive()["attributes"]["TEXCOORD_0"] = turned.addFloats("VEC2", {0, 0, 0, 1, 1, 1, 1, 0});
  for (const asset::Vertex& v : turned.load().vertices) expectTangent(v, {0, 1, 0}, 1);
}

TEST(Tangents, FollowTheMirroringNode) {
  GltfBuilder builder = texturedSquare(kNormalMapped);
  builder.addTexture(kFlatMap);
  builder.json["nodes"][0]["scale"] = {-1, 1, 1};
  for (const asset::Vertex& v : builder.load().vertices) expectTangent(v, {-1, 0, 0}, -1);
}

TEST(Tangents, OfTheSetThatTheNormalTextureReads) {
  GltfBuilder builder = texturedSquare({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}});
  builder.addTexture(kFlatMap);
  builder.primitive()["attributes"]["TEXCOORD_1"] = builder.addFloats("VEC2", {1, 1, 0, 1, 0, 0, 1, 0});
  for (const asset::Vertex& v : builder.load().vertices) expectTangent(v, {-1, 0, 0}, -1);
}

TEST(Tangents, GivenOnesAreKept) {
  GltfBuilder builder = texturedSquare(kNormalMapped);
  builder.addTexture(kFlatMap);
  builder.primitive()["attributes"]["TANGENT"] =
      builder.addFloats("VEC4", {0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1});
  for (const asset::Vertex& v : builder.load().vertices) expectTangent(v, {0, 1, 0}, -1);
}

asset::Vertex vertex(vec3 p, vec2 uv) {
  return {.position = {p.x, p.y, p.z}, .normal = {0, 0, 1}, .uv = {{uv.x, uv.y}, {}}, .color = {1, 1, 1, 1}};
}

// Two triangles that share the edge x = 0, with an image that is mirrored across it.
TEST(Tangents, VerticesSplitWhereTheImageIsMirrored) {
  Mesh mesh;
  mesh.vertices = {vertex({0, 0, 0}, {0, 1}), vertex({0, 1, 0}, {0, 0}), vertex({1, 0, 0}, {1, 1}),
                   vertex({-1, 0, 0}, {1, 1})};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  computeTangents(mesh, 0);
  ASSERT_EQ(mesh.vertices.size(), 6u);
  for (int c = 0; c < 3; ++c) {
    expectTangent(mesh.vertices[mesh.triangles[0][c]], {1, 0, 0}, 1);
    expectTangent(mesh.vertices[mesh.triangles[1][c]], {-1, 0, 0}, -1);
  }
  EXPECT_EQ(positionOf(mesh.vertices[mesh.triangles[1][1]]), dvec3(0, 1, 0))
      << "the copy is of the right vertex";
}

// A corner between triangles of 90 and 45 degrees, whose images are turned by 90 degrees against each other.
TEST(Tangents, AreWeightedByAngle) {
  Mesh mesh;
  mesh.vertices = {vertex({0, 0, 0}, {0, 0}), vertex({1, 0, 0}, {1, 0}), vertex({0, 1, 0}, {0, -1}),
                   vertex({-1, 1, 0}, {1, -1})};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  // u grows by one along +X in the first; in the second along -X, with v up: mirrored against the first.
  computeTangents(mesh, 0);
  EXPECT_EQ(mesh.vertices.size(), 6u);

  mesh.vertices.resize(4);
  mesh.vertices[3] = vertex({-1, 1, 0}, {-1, 0});  // u along +Y - X... : u grows with x + y
  mesh.vertices[2] = vertex({0, 1, 0}, {0, -1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  computeTangents(mesh, 0);
  // First: u = x, direction (1,0), 90 degrees. Second: u = x, v = -(x + y): direction of growing u with v
  // fixed is (1,-1)/sqrt 2, 45 degrees.
  const vec3 expected = glm::normalize(2.0f * vec3(1, 0, 0) + vec3(1, -1, 0) / std::sqrt(2.0f));
  expectTangent(mesh.vertices[0], expected, 1);
}

TEST(Tangents, EqualVerticesShareThem) {
  Mesh indexed, single;
  indexed.vertices = {vertex({0, 0, 0}, {0, 0}), vertex({1, 0, 0}, {1, 0}), vertex({0, 1, 0}, {0, -1}),
                      vertex({-1, 1, 0}, {-1, 0})};
  indexed.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const uvec3& t : indexed.triangles) {
    const uint32_t first = uint32_t(single.vertices.size());
    for (int c = 0; c < 3; ++c) single.vertices.push_back(indexed.vertices[t[c]]);
    single.triangles.push_back({first, first + 1, first + 2});
  }
  computeTangents(indexed, 0);
  computeTangents(single, 0);
  EXPECT_EQ(tangentOf(single.vertices[0]), tangentOf(indexed.vertices[0]));
  EXPECT_EQ(tangentOf(single.vertices[3]), tangentOf(indexed.vertices[0]));
}

TEST(Tangents, DegenerateUvStillGivesAFrame) {
  GltfBuilder builder = texturedSquare(kNormalMapped);
  builder.addTexture(kFlatMap);
  builder.primitive()["attributes"]["TEXCOORD_0"] = builder.addFloats("VEC2", std::vector<float>(8, .5f));
  for (const asset::Vertex& v : builder.load().vertices) {
    EXPECT_NEAR(glm::length(tangentOf(v)), 1.0, 1e-6);
    EXPECT_NEAR(glm::dot(tangentOf(v), normalOf(v)), 0.0, 1e-6);
  }
}

// TEXCOORD_0 upright (tangent +X), TEXCOORD_1 turned (tangent +Y).
GltfBuilder twoSets(const Json& material) {
  GltfBuilder builder = texturedSquare(material);
  builder.addTexture(kFlatMap);
  builder.primitive()["attributes"]["TEXCOORD_1"] = builder.addFloats("VEC2", {0, 0, 0, 1, 1, 1, 1, 0});
  return builder;
}
Json anisotropic(const Json& more = Json::object()) {
  Json members = {{"anisotropyStrength", .5}};
  members.update(more);
  return {{"extensions", {{"KHR_materials_anisotropy", members}}}};
}
const Json kSet0 = {{"index", 0}}, kSet1 = {{"index", 0}, {"texCoord", 1}};

void expectTangents(const GltfBuilder& builder, vec3 direction) {
  for (const asset::Vertex& v : builder.load().vertices) expectTangent(v, direction, 1);
}

TEST(Tangents, AnisotropyNeedsThem) {
  const vec3 x(1, 0, 0), y(0, 1, 0);
  expectTangents(twoSets(anisotropic()), x);
  expectTangents(twoSets(anisotropic({{"anisotropyTexture", kSet1}})), y);
  Json both = anisotropic();
  both["normalTexture"] = kSet1;
  expectTangents(twoSets(both), y);
  both["extensions"]["KHR_materials_anisotropy"]["anisotropyTexture"] = kSet0;
  expectTangents(twoSets(both), x);
  GltfBuilder onlySet1 = twoSets(anisotropic());
  onlySet1.primitive()["attributes"].erase("TEXCOORD_0");
  expectTangents(onlySet1, y);
}

TEST(Tangents, TheFilesOwnComeFirst) {
  GltfBuilder builder = twoSets(anisotropic());
  builder.primitive()["attributes"]["TANGENT"] =
      builder.addFloats("VEC4", {0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1});
  expectTangents(builder, {0, -1, 0});
}

TEST(Tangents, TheClearcoatsNormalTextureNeedsThem) {
  const Json coat = {{"clearcoatFactor", 1}, {"clearcoatNormalTexture", kSet1}};
  expectTangents(twoSets({{"extensions", {{"KHR_materials_clearcoat", coat}}}}), {0, 1, 0});
}

TEST(Tangents, AnisotropyWithoutUvGetsAFrame) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["material"] = builder.add("materials", anisotropic());
  for (const asset::Vertex& v : builder.load().vertices) {
    EXPECT_NEAR(glm::length(tangentOf(v)), 1.0, 1e-6);
    EXPECT_NEAR(glm::dot(tangentOf(v), normalOf(v)), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace boxlight::test
