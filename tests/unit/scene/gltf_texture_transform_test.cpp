// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "common/base/error.h"
#include "gltf_builder.h"

namespace boxlight::test {
namespace {

Json textureInfo(const Json& transform) {
  return {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
}

Scene sceneOf(const Json& material) {
  GltfBuilder builder = texturedSquare(material);
  builder.primitive()["attributes"]["TEXCOORD_1"] = builder.primitive()["attributes"]["TEXCOORD_0"];
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  return builder.load();
}
Scene withBaseColor(const Json& info) {
  return sceneOf({{"pbrMetallicRoughness", {{"baseColorTexture", info}}}});
}

// Where the base colour of the only material is read for uv.
vec2 transformed(const Scene& scene, vec2 uv) {
  const asset::TextureRef ref = scene.materials.at(0).baseColorTexture;
  if (ref.transform == 0) return uv;
  const auto& rows = scene.textureTransforms.at(ref.transform - 1).rows;
  return {rows[0][0] * uv.x + rows[0][1] * uv.y + rows[0][2],
          rows[1][0] * uv.x + rows[1][1] * uv.y + rows[1][2]};
}

void expectAt(const Json& transform, vec2 uv, vec2 expected) {
  const vec2 actual = transformed(withBaseColor(textureInfo(transform)), uv);
  EXPECT_NEAR(actual.x, expected.x, 1e-6) << transform;
  EXPECT_NEAR(actual.y, expected.y, 1e-6) << transform;
}

TEST(GltfTextureTransform, ByHand) {
  constexpr double kQuarter = std::numbers::pi / 2, kSixth = std::numbers::pi / 6;
  expectAt({{"offset", {.25, -.5}}}, {.5f, .5f}, {.75f, 0});
  expectAt({{"scale", {2, -3}}}, {.5f, .25f}, {1, -.75f});
  // In the image, whose v grows downwards, u turns counter-clockwise to point up.
  expectAt({{"rotation", kQuarter}}, {1, 0}, {0, -1});
  expectAt({{"rotation", kQuarter}}, {0, 1}, {1, 0});
  expectAt({{"rotation", kSixth}}, {1, 0}, {.8660254f, -.5f});
  // Scaled, then turned, then moved.
  expectAt({{"offset", {.1, .2}}, {"rotation", kQuarter}, {"scale", {2, 3}}}, {1, 1}, {3.1f, -1.8f});
}

// The specification's example of a quarter turn: the whole square shows the lower left quadrant.
TEST(GltfTextureTransform, TheSpecificationsExample) {
  const Json example = {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {.5, .5}}};
  expectAt(example, {0, 0}, {0, 1});
  expectAt(example, {1, 0}, {0, .5f});
  expectAt(example, {0, 1}, {.5f, 1});
  expectAt(example, {1, 1}, {.5f, .5f});
}

TEST(GltfTextureTransform, WhatMovesNothingMakesNoEntry) {
  for (const Json& identity : {Json::object(), Json{{"offset", {0, 0}}, {"rotation", 0}, {"scale", {1, 1}}},
                               Json{{"texCoord", 0}}, Json{{"offset", {-0.0, 0}}}}) {
    const Scene scene = withBaseColor(textureInfo(identity));
    EXPECT_TRUE(scene.textureTransforms.empty()) << identity;
    EXPECT_EQ(scene.materials[0].baseColorTexture.transform, 0) << identity;
  }
}

TEST(GltfTextureTransform, OverridesTheCoordinateSet) {
  Json info = textureInfo({{"texCoord", 1}});
  EXPECT_EQ(withBaseColor(info).materials[0].baseColorTexture.texcoord, 1);
  info = textureInfo({{"texCoord", 0}});
  info["texCoord"] = 1;
  EXPECT_EQ(withBaseColor(info).materials[0].baseColorTexture.texcoord, 0);
  info["texCoord"] = 7;
  EXPECT_EQ(withBaseColor(info).materials[0].baseColorTexture.texcoord, 0) << "set 7 is not read";
}

TEST(GltfTextureTransform, OnEveryTextureAndEachDifferentOneOnce) {
  const Json half = textureInfo({{"scale", {.5, .5}}}), moved = textureInfo({{"offset", {.5, 0}}});
  const Scene scene =
      sceneOf({{"pbrMetallicRoughness", {{"baseColorTexture", half}, {"metallicRoughnessTexture", moved}}},
               {"normalTexture", half},
               {"emissiveTexture", moved},
               {"emissiveFactor", {1, 1, 1}},
               {"extensions",
                {{"KHR_materials_specular", {{"specularTexture", half}, {"specularColorTexture", moved}}},
                 {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatNormalTexture", half}}}}}});
  ASSERT_EQ(scene.textureTransforms.size(), 2u);
  const asset::Material& m = scene.materials[0];
  const asset::MaterialExtension& x = scene.materialExtensions.at(0);
  EXPECT_EQ(m.baseColorTexture.transform, 1);
  EXPECT_EQ(m.metallicRoughnessTexture.transform, 2);
  EXPECT_EQ(m.normalTexture.transform, 1);
  EXPECT_EQ(m.specularTexture.transform, 1);
  EXPECT_EQ(m.specularColorTexture.transform, 2);
  EXPECT_EQ(x.clearcoatNormalTexture.transform, 1);
  EXPECT_EQ(x.emissiveTexture.transform, 2);
}

void expectInvalid(const Json& info, const std::string& place) {
  try {
    withBaseColor(info);
    ADD_FAILURE() << info << " was loaded";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalidInput);
    EXPECT_NE(std::string(error.what()).find("baseColorTexture.extensions" + place), std::string::npos)
        << error.what();
  }
}

TEST(GltfTextureTransform, HostileValues) {
  expectInvalid(textureInfo({{"offset", {1}}}), ".KHR_texture_transform.offset");
  expectInvalid(textureInfo({{"scale", 2}}), ".KHR_texture_transform.scale");
  expectInvalid(textureInfo({{"rotation", {0}}}), ".KHR_texture_transform.rotation");
  expectInvalid(textureInfo({{"texCoord", -1}}), ".KHR_texture_transform.texCoord");
  expectInvalid(textureInfo(3), ".KHR_texture_transform");
  expectInvalid(textureInfo({{"offset", {1e300, 0}}}), ".KHR_texture_transform: 1e+300 is beyond");
  expectInvalid({{"index", 0}, {"extensions", 3}}, "");
}

TEST(GltfTextureTransform, TheHashOfASceneKnowsThem) {
  EXPECT_NE(withBaseColor(textureInfo({{"offset", {.5, 0}}})).hash,
            withBaseColor(textureInfo({{"offset", {.25, 0}}})).hash);
}

}  // namespace
}  // namespace boxlight::test
