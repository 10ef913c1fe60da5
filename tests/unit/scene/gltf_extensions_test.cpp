// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "common/asset/texture_references.h"
#include "common/base/error.h"
#include "gltf_builder.h"
#include "log_capture.h"

namespace boxlight::test {
namespace {

using asset::MaterialExtension;

Json texture(int texcoord = 0) { return {{"index", 0}, {"texCoord", texcoord}}; }

// Every supported extension with a value of its own in each member.
Json everything() {
  return {{"emissiveFactor", {.25, .5, 1}},
          {"emissiveTexture", texture(1)},
          {"extensions",
           {{"KHR_materials_anisotropy",
             {{"anisotropyStrength", .1}, {"anisotropyRotation", -7}, {"anisotropyTexture", texture()}}},
            {"KHR_materials_clearcoat",
             {{"clearcoatFactor", .2},
              {"clearcoatTexture", texture(1)},
              {"clearcoatRoughnessFactor", .3},
              {"clearcoatRoughnessTexture", texture()},
              {"clearcoatNormalTexture", {{"index", 0}, {"texCoord", 1}, {"scale", -2}}}}},
            {"KHR_materials_sheen",
             {{"sheenColorFactor", {.11, .12, .13}},
              {"sheenColorTexture", texture()},
              {"sheenRoughnessFactor", .4},
              {"sheenRoughnessTexture", texture(1)}}},
            {"KHR_materials_ior", {{"ior", 1.33}}},
            {"KHR_materials_transmission", {{"transmissionFactor", .6}, {"transmissionTexture", texture(1)}}},
            {"KHR_materials_volume",
             {{"thicknessFactor", .01}, {"attenuationDistance", .5}, {"attenuationColor", {1, .5, .25}}}},
            {"KHR_materials_diffuse_transmission",
             {{"diffuseTransmissionFactor", .7},
              {"diffuseTransmissionTexture", texture()},
              {"diffuseTransmissionColorFactor", {.21, .22, .23}},
              {"diffuseTransmissionColorTexture", texture(1)}}},
            {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
            {"KHR_materials_iridescence",
             {{"iridescenceFactor", .8},
              {"iridescenceTexture", texture()},
              {"iridescenceIor", 1.8},
              {"iridescenceThicknessMinimum", 150},
              {"iridescenceThicknessMaximum", 450},
              {"iridescenceThicknessTexture", texture(1)}}}}}};
}

GltfBuilder squareOf(const Json& material) {
  GltfBuilder builder = texturedSquare(material);
  builder.primitive()["attributes"]["TEXCOORD_1"] = builder.primitive()["attributes"]["TEXCOORD_0"];
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  return builder;
}

Scene sceneOf(const Json& material) { return squareOf(material).load(); }
MaterialExtension extensionOf(const Json& material) { return sceneOf(material).materialExtensions.at(0); }

// A material with one extension.
Json with(const char* name, const Json& members) { return {{"extensions", {{name, members}}}}; }

void expectColor(const float (&actual)[3], vec3 expected) {
  for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(actual[c], expected[c]) << c;
}

TEST(GltfExtensions, FactorsAreInTheirFields) {
  const Scene scene = sceneOf(everything());
  const MaterialExtension& x = scene.materialExtensions.at(0);
  EXPECT_FLOAT_EQ(x.ior, 1.33f);
  EXPECT_FLOAT_EQ(x.anisotropy, .1f);
  EXPECT_FLOAT_EQ(x.anisotropyRotation, -7.0f);
  EXPECT_FLOAT_EQ(x.clearcoat, .2f);
  EXPECT_FLOAT_EQ(x.clearcoatRoughness, .3f);
  EXPECT_FLOAT_EQ(x.clearcoatNormalScale, -2.0f);
  expectColor(x.sheenColor, {.11f, .12f, .13f});
  EXPECT_FLOAT_EQ(x.sheenRoughness, .4f);
  EXPECT_FLOAT_EQ(x.transmission, .6f);
  EXPECT_FLOAT_EQ(x.diffuseTransmission, .7f);
  expectColor(x.diffuseTransmissionColor, {.21f, .22f, .23f});
  EXPECT_FLOAT_EQ(x.iridescence, .8f);
  EXPECT_FLOAT_EQ(x.iridescenceIor, 1.8f);
  EXPECT_FLOAT_EQ(x.iridescenceThickness[0], 150.0f);
  EXPECT_FLOAT_EQ(x.iridescenceThickness[1], 450.0f);
  expectColor(x.emissive, {1, 2, 4});
  expectColor(x.absorption, {0, 1.3862944f, 2.7725887f});  // ln 2 / .5 and ln 4 / .5
  expectColor(x.scattering, {0, 0, 0});
  EXPECT_EQ(scene.materials[0].flags, asset::kVolume);
}

TEST(GltfExtensions, TexturesAreInTheirFieldsAndColourSpaces) {
  const Scene scene = sceneOf(everything());
  const std::set<std::string> inSrgb = {"sheenColorTexture", "diffuseTransmissionColorTexture",
                                        "emissiveTexture"};
  const std::set<std::string> inSet1 = {
      "clearcoatTexture",    "clearcoatNormalTexture",          "sheenRoughnessTexture",
      "transmissionTexture", "diffuseTransmissionColorTexture", "iridescenceThicknessTexture",
      "emissiveTexture"};
  int count = 0;
  asset::forEachReference(scene.materialExtensions.at(0),
                          [&](const std::string& name, asset::TextureRef ref) {
                            ASSERT_LT(ref.texture, scene.textures.size()) << name;
                            EXPECT_EQ(scene.textures[ref.texture].srgb, inSrgb.contains(name)) << name;
                            EXPECT_EQ(ref.texcoord, inSet1.contains(name)) << name;
                            EXPECT_EQ(ref.transform, 0) << name;
                            ++count;
                          });
  EXPECT_EQ(count, 12);
}

// In every one the textures alone would be read if the factor did not make them idle.
TEST(GltfExtensions, WhatHasNoEffectAddsNoRecord) {
  Json material = everything();
  material["emissiveFactor"] = {0, 0, 0};
  Json& x = material["extensions"];
  x["KHR_materials_anisotropy"]["anisotropyStrength"] = 0;
  x["KHR_materials_clearcoat"]["clearcoatFactor"] = 0;
  x["KHR_materials_sheen"]["sheenColorFactor"] = {0, 0, 0};
  x["KHR_materials_ior"]["ior"] = 1.5;
  x["KHR_materials_transmission"]["transmissionFactor"] = 0;
  x["KHR_materials_volume"]["thicknessFactor"] = 0;
  x["KHR_materials_diffuse_transmission"]["diffuseTransmissionFactor"] = 0;
  x["KHR_materials_iridescence"]["iridescenceFactor"] = 0;
  const Scene scene = sceneOf(material);
  EXPECT_TRUE(scene.materialExtensions.empty());
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_EQ(scene.materials[0].flags, 0u);
  Json defaults;
  for (const auto& [name, members] : x.items()) defaults["extensions"][name] = Json::object();
  EXPECT_TRUE(sceneOf(defaults).materialExtensions.empty());
}

// One way to give a material a record at a time; the rest of the record stays as it is by default.
TEST(GltfExtensions, EachTermAloneMakesARecord) {
  for (const Json& material :
       {with("KHR_materials_anisotropy", {{"anisotropyStrength", .5}}),
        with("KHR_materials_clearcoat", {{"clearcoatFactor", .5}}),
        with("KHR_materials_sheen", {{"sheenColorFactor", {0, .5, 0}}}),
        with("KHR_materials_ior", {{"ior", 1.4}}),
        with("KHR_materials_transmission", {{"transmissionFactor", .5}}),
        with("KHR_materials_volume", {{"thicknessFactor", .5}}),
        with("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", .5}}),
        with("KHR_materials_iridescence", {{"iridescenceFactor", .5}}),
        with("KHR_materials_unlit", Json::object()), Json{{"emissiveFactor", {0, 0, .5}}},
        Json{{"alphaMode", "BLEND"}}})
    EXPECT_EQ(sceneOf(material).materialExtensions.size(), 1u) << material;
}

TEST(GltfExtensions, OneRecordForEachMaterialOnceAnyHasOne) {
  GltfBuilder builder = oneTriangle();
  builder.json["materials"] = {{{"name", "plain"}}, {{"emissiveFactor", {1, 0, 0}}}, {{"name", "plain too"}}};
  builder.json["meshes"][0]["primitives"] = Json::array();
  for (int i = 0; i < 3; ++i)
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"material", i}});
  const Scene scene = builder.load();
  ASSERT_EQ(scene.materialExtensions.size(), 3u);
  for (size_t i = 0; i < 3; ++i) expectColor(scene.materialExtensions[i].emissive, {i == 1, 0, 0});
}

TEST(GltfExtensions, IndexOfRefraction) {
  EXPECT_EQ(extensionOf(with("KHR_materials_ior", {{"ior", 0}})).ior, 0.0f) << "allowed: all is reflected";
  EXPECT_EQ(extensionOf(with("KHR_materials_ior", {{"ior", 1}})).ior, 1.0f);
  for (const double outside : {.5, -2.0}) {
    const LogCapture capture;
    EXPECT_EQ(extensionOf(with("KHR_materials_ior", {{"ior", outside}})).ior, 1.0f);
    EXPECT_NE(capture.text().find("KHR_materials_ior.ior"), std::string::npos) << capture.text();
  }
}

TEST(GltfExtensions, EmissionWithoutStrengthIsTheCores) {
  expectColor(extensionOf({{"emissiveFactor", {1, .5, .25}}}).emissive, {1, .5f, .25f});
  EXPECT_TRUE(
      sceneOf(with("KHR_materials_emissive_strength", {{"emissiveStrength", 9}})).materialExtensions.empty())
      << "9 times nothing";
}

TEST(GltfExtensions, DefaultsOfWhatIsOpen) {
  const MaterialExtension film = extensionOf(with("KHR_materials_iridescence", {{"iridescenceFactor", 1}}));
  EXPECT_FLOAT_EQ(film.iridescenceIor, 1.3f);
  EXPECT_EQ(film.iridescenceThickness[0], 100.0f);
  EXPECT_EQ(film.iridescenceThickness[1], 400.0f);
  const MaterialExtension leaf =
      extensionOf(with("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1}}));
  expectColor(leaf.diffuseTransmissionColor, {1, 1, 1});
  const MaterialExtension glass = extensionOf(with("KHR_materials_volume", {{"thicknessFactor", 1}}));
  expectColor(glass.absorption, {0, 0, 0});
}

struct Range {
  const char* extension;
  const char* member;
  Json value;     // out of range
  size_t offset;  // of the first float that holds it
  float clamped;
};

TEST(GltfExtensions, OutOfRangeIsClampedWithAWarning) {
  const Range ranges[] = {
      {"anisotropy", "anisotropyStrength", 2, offsetof(MaterialExtension, anisotropy), 1},
      {"clearcoat", "clearcoatFactor", 3, offsetof(MaterialExtension, clearcoat), 1},
      {"clearcoat", "clearcoatRoughnessFactor", -1, offsetof(MaterialExtension, clearcoatRoughness), 0},
      {"sheen", "sheenColorFactor", {2, 0, 0}, offsetof(MaterialExtension, sheenColor), 1},
      {"sheen", "sheenRoughnessFactor", 1.5, offsetof(MaterialExtension, sheenRoughness), 1},
      {"transmission", "transmissionFactor", 1.5, offsetof(MaterialExtension, transmission), 1},
      {"diffuse_transmission", "diffuseTransmissionFactor", 7,
       offsetof(MaterialExtension, diffuseTransmission), 1},
      {"diffuse_transmission",
       "diffuseTransmissionColorFactor",
       {-1, 0, 0},
       offsetof(MaterialExtension, diffuseTransmissionColor),
       0},
      {"iridescence", "iridescenceFactor", 1.1, offsetof(MaterialExtension, iridescence), 1},
      {"iridescence", "iridescenceIor", .5, offsetof(MaterialExtension, iridescenceIor), 1},
      {"iridescence", "iridescenceThicknessMinimum", -5, offsetof(MaterialExtension, iridescenceThickness),
       0},
      {"emissive_strength", "emissiveStrength", -1, offsetof(MaterialExtension, emissive), 0},
      {"volume", "attenuationColor", {2, .5, .5}, offsetof(MaterialExtension, absorption), 0},
  };
  for (const Range& range : ranges) {
    Json material = everything();
    material["extensions"]["KHR_materials_" + std::string(range.extension)][range.member] = range.value;
    const LogCapture capture;
    const MaterialExtension x = extensionOf(material);
    float actual;
    std::memcpy(&actual, reinterpret_cast<const std::byte*>(&x) + range.offset, sizeof actual);
    EXPECT_EQ(actual, range.clamped) << range.member;
    const std::string expected =
        "materials[0].extensions.KHR_materials_" + std::string(range.extension) + "." + range.member;
    EXPECT_NE(capture.text().find(expected), std::string::npos) << capture.text();
  }
}

TEST(GltfExtensions, AWrongTypeAnywhereIsInvalid) {
  const Json whole = everything();
  int tried = 0;
  for (const auto& [name, members] : whole["extensions"].items())
    for (const auto& [member, value] : members.items()) {
      Json material = whole;
      material["extensions"][name][member] = "text";
      try {
        sceneOf(material);
        ADD_FAILURE() << name << "." << member << " as text was loaded";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalidInput) << error.what();
        const std::string place = "materials[0].extensions." + name + "." + member;
        EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
      }
      ++tried;
    }
  EXPECT_EQ(tried, 29);
}

TEST(GltfExtensions, ATextureNeedsItsCoordinates) {
  GltfBuilder builder = squareOf(
      with("KHR_materials_transmission", {{"transmissionFactor", 1}, {"transmissionTexture", texture(1)}}));
  builder.primitive()["attributes"].erase("TEXCOORD_1");
  try {
    builder.load();
    ADD_FAILURE() << "was loaded";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("TEXCOORD_1: missing, but the transmissionTexture"),
              std::string::npos)
        << error.what();
  }
}

TEST(GltfExtensions, UnlitWinsAndSaysWhatItIgnores) {
  Json material = everything();
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  const LogCapture capture;
  const Scene scene = sceneOf(material);
  EXPECT_EQ(scene.materials[0].flags, asset::kUnlit);
  const MaterialExtension nothing;
  ASSERT_EQ(scene.materialExtensions.size(), 1u);
  EXPECT_EQ(std::memcmp(&scene.materialExtensions[0], &nothing, sizeof nothing), 0);
  EXPECT_NE(capture.text().find("KHR_materials_unlit leaves no place for KHR_materials_anisotropy, "),
            std::string::npos)
      << capture.text();
  const LogCapture alone;
  sceneOf(with("KHR_materials_unlit", Json::object()));
  EXPECT_EQ(alone.text(), "");
}

TEST(GltfExtensions, BlendIsAFlag) {
  const Scene scene = sceneOf({{"alphaMode", "BLEND"}});
  EXPECT_EQ(scene.materials[0].flags, asset::kAlphaBlend);
}

TEST(GltfExtensions, TheHashOfASceneKnowsThem) {
  const Scene plain = sceneOf(Json::object()), dim = sceneOf({{"emissiveFactor", {.5, 0, 0}}}),
              bright = sceneOf({{"emissiveFactor", {1, 0, 0}}});
  EXPECT_NE(plain.hash, dim.hash);
  EXPECT_NE(dim.hash, bright.hash);
}

}  // namespace
}  // namespace boxlight::test
