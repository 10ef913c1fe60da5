// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "gltf_builder.h"

namespace boxlight::test {
namespace {

using asset::kNone;

TEST(GltfMaterial, DefaultWherePrimitiveHasNone) {
  const Scene scene = oneTriangle().load();
  ASSERT_EQ(scene.materials.size(), 1u);
  const asset::Material& m = scene.materials[0];
  EXPECT_EQ(m.baseColor[3], 1.0f);
  EXPECT_EQ(m.metallic, 1.0f);
  EXPECT_EQ(m.roughness, 1.0f);
  EXPECT_EQ(m.specular, 1.0f);
  EXPECT_EQ(m.flags, 0u);
  EXPECT_EQ(m.baseColorTexture.texture, kNone);
}

TEST(GltfMaterial, FactorsAndFlags) {
  GltfBuilder builder = oneTriangle();
  builder.json["materials"] = {
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {.1, .2, .3, .4}}, {"metallicFactor", .5}, {"roughnessFactor", .6}}},
       {"alphaMode", "MASK"},
       {"alphaCutoff", .7},
       {"doubleSided", true},
       {"emissiveFactor", {1, 0, 0}},
       {"extensions",
        {{"KHR_materials_specular", {{"specularFactor", 0}, {"specularColorFactor", {2, 1, .5}}}}}}}};
  builder.primitive()["material"] = 0;
  const asset::Material m = builder.load().materials.at(0);
  EXPECT_FLOAT_EQ(m.baseColor[0], .1f);
  EXPECT_FLOAT_EQ(m.baseColor[3], .4f);
  EXPECT_FLOAT_EQ(m.metallic, .5f);
  EXPECT_FLOAT_EQ(m.roughness, .6f);
  EXPECT_FLOAT_EQ(m.alphaCutoff, .7f);
  EXPECT_EQ(m.flags, asset::kAlphaMask | asset::kDoubleSided);
  EXPECT_EQ(m.specular, 0.0f);
  EXPECT_EQ(m.specularColor[0], 2.0f);
  EXPECT_EQ(m.specularColor[2], .5f);
}

TEST(GltfMaterial, FactorsOutOfRangeAreClamped) {
  GltfBuilder builder = oneTriangle();
  builder.json["materials"] = {
      {{"pbrMetallicRoughness", {{"metallicFactor", -1}, {"roughnessFactor", 1.5}}}}};
  builder.primitive()["material"] = 0;
  const asset::Material m = builder.load().materials.at(0);
  EXPECT_EQ(m.metallic, 0.0f);
  EXPECT_EQ(m.roughness, 1.0f);
}

TEST(GltfMaterial, OnlyThoseInUseInOrderOfUse) {
  GltfBuilder builder = oneTriangle();
  builder.json["materials"] = {{{"alphaMode", "BLEND"}},
                               {{"pbrMetallicRoughness", {{"roughnessFactor", .25}}}},
                               {{"pbrMetallicRoughness", {{"roughnessFactor", .75}}}}};
  builder.json["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", 0}}}, {"material", 2}},
                                             {{"attributes", {{"POSITION", 0}}}, {"material", 1}},
                                             {{"attributes", {{"POSITION", 0}}}, {"material", 2}}};
  const Scene scene = builder.load();
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].roughness, .75f);
  EXPECT_EQ(scene.materials[1].roughness, .25f);
  EXPECT_EQ(scene.triangles[0].material, 0u);
  EXPECT_EQ(scene.triangles[1].material, 1u);
  EXPECT_EQ(scene.triangles[2].material, 0u);
}

TEST(GltfMaterial, EveryTextureInItsColourSpace) {
  GltfBuilder builder =
      texturedSquare({{"pbrMetallicRoughness",
                       {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 0}}}}},
                      {"normalTexture", {{"index", 0}, {"texCoord", 1}, {"scale", .5}}},
                      {"extensions",
                       {{"KHR_materials_specular",
                         {{"specularTexture", {{"index", 0}}},
                          {"specularColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}}});
  builder.primitive()["attributes"]["TEXCOORD_1"] = builder.primitive()["attributes"]["TEXCOORD_0"];
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  const Scene scene = builder.load();
  const asset::Material& m = scene.materials[0];
  EXPECT_EQ(scene.texels, std::vector<uint32_t>{0x04030201u}) << "texels are stored once per image";
  ASSERT_EQ(scene.textures.size(), 2u) << "one per colour space";
  EXPECT_EQ(m.specularColorTexture.texture, m.baseColorTexture.texture);
  EXPECT_EQ(m.normalTexture.texture, m.metallicRoughnessTexture.texture);
  EXPECT_EQ(m.specularTexture.texture, m.metallicRoughnessTexture.texture);
  EXPECT_EQ(scene.textures[m.baseColorTexture.texture].srgb, 1u);
  EXPECT_EQ(scene.textures[m.normalTexture.texture].srgb, 0u);
  EXPECT_EQ(m.normalTexture.texcoord, 1u);
  EXPECT_EQ(m.specularColorTexture.texcoord, 1u);
  EXPECT_EQ(m.specularTexture.texcoord, 0u);
  EXPECT_EQ(m.normalScale, .5f);
}

TEST(GltfMaterial, Samplers) {
  GltfBuilder builder = texturedSquare(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 1}}}});
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  builder.addTexture(png(1, 1, {1, 2, 3, 4}),
                     {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9729}});
  const Scene scene = builder.load();
  const asset::Texture& open = scene.textures[scene.materials[0].baseColorTexture.texture];
  EXPECT_EQ(open.wrapS, asset::Wrap::repeat);
  EXPECT_EQ(open.magNearest, 0u);
  EXPECT_EQ(open.minFilter, 2u);
  const asset::Texture& given = scene.textures[scene.materials[0].normalTexture.texture];
  EXPECT_EQ(given.wrapS, asset::Wrap::clampToEdge);
  EXPECT_EQ(given.wrapT, asset::Wrap::mirroredRepeat);
  EXPECT_EQ(given.magNearest, 1u);
  EXPECT_EQ(given.minFilter, 1u);
  EXPECT_EQ(given.firstTexel, 1u);
}

TEST(GltfMaterial, SixteenBitsAreRounded) {
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.addTexture(png(1, 1, {0, 128, 129, 65535}, 16));  // half a step of 8 bits is 128.5
  EXPECT_EQ(builder.load().texels, std::vector<uint32_t>{0xFF010000u});
}

}  // namespace
}  // namespace boxlight::test
