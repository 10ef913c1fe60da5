// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_scatter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"
#include "gltf_builder.h"
#include "log_capture.h"

namespace boxlight::test {
namespace {

using asset::MaterialExtension;

// ln 2 / 10 cm, ln 4 / 10 cm, ln 10 / 10 cm.
const Json kVolume = {
    {"thicknessFactor", 1}, {"attenuationDistance", .1}, {"attenuationColor", {.5, .25, .1}}};
const double kAttenuation[3] = {std::log(2.0) / .1, std::log(4.0) / .1, std::log(10.0) / .1};

Scene sceneOf(const Json& material) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["material"] = builder.add("materials", material);
  return builder.load();
}
MaterialExtension extensionOf(const Json& material) { return sceneOf(material).materialExtensions.at(0); }
Json draft(const Json& scatter) {
  return {{"extensions", {{"KHR_materials_volume", kVolume}, {"KHR_materials_volume_scatter", scatter}}}};
}
Json extras(const Json& scatter) {
  return {{"extensions", {{"KHR_materials_volume", kVolume}}}, {"extras", {{"boxlight_scatter", scatter}}}};
}

// By the closed form of Kulla and Conty, worked out by hand for g = 0: (c, albedo).
TEST(GltfScatter, SingleScatteringAlbedo) {
  const double byHand[][2] = {{0, 0}, {.25, .69343}, {.5, .91171}, {.75, .98436}, {1, 1}};
  for (const auto& [color, albedo] : byHand)
    EXPECT_NEAR(singleScatteringAlbedo(color, 0), albedo, 2e-5) << color;
}

// The similarity relation: the albedo of a medium with g scatters as the isotropic one with a (1 - g) / (1 -
// g a).
TEST(GltfScatter, AnisotropyKeepsTheReducedAlbedo) {
  for (const double g : {-.7, .3, .9})
    for (const double color : {.1, .5, .9}) {
      const double isotropic = singleScatteringAlbedo(color, 0), albedo = singleScatteringAlbedo(color, g);
      EXPECT_NEAR(albedo * (1 - g) / (1 - g * albedo), isotropic, 1e-12) << g << " " << color;
    }
}

TEST(GltfScatter, AVolumeAloneOnlyAbsorbs) {
  const MaterialExtension x = extensionOf({{"extensions", {{"KHR_materials_volume", kVolume}}}});
  for (int c = 0; c < 3; ++c) {
    EXPECT_FLOAT_EQ(x.absorption[c], float(kAttenuation[c]));
    EXPECT_EQ(x.scattering[c], 0.0f);
  }
}

void expectScattering(const MaterialExtension& x, vec3 color, double g) {
  EXPECT_FLOAT_EQ(x.scatterAnisotropy, float(g));
  for (int c = 0; c < 3; ++c) {
    const double albedo = singleScatteringAlbedo(color[c], g);
    EXPECT_NEAR(x.scattering[c], albedo * kAttenuation[c], 1e-4) << c;
    EXPECT_NEAR(x.scattering[c] + x.absorption[c], kAttenuation[c], 1e-5) << "nothing is lost";
  }
}

TEST(GltfScatter, TheDraftUnderBothNamesAndTheExtras) {
  const Json newer = {{"multiscatterColorFactor", {.25, .5, .75}}, {"scatterAnisotropy", .5}};
  const Json older = {{"multiscatterColor", {.25, .5, .75}}, {"scatterAnisotropy", .5}};
  for (const Json& material : {draft(newer), draft(older), extras(newer), extras(older)}) {
    const Scene scene = sceneOf(material);
    EXPECT_EQ(scene.materials[0].flags, asset::kVolume);
    expectScattering(scene.materialExtensions.at(0), {.25f, .5f, .75f}, .5);
  }
}

TEST(GltfScatter, ExtrasComeBeforeTheDraft) {
  Json material = draft({{"multiscatterColorFactor", {1, 1, 1}}});
  material["extras"]["boxlight_scatter"] = {{"multiscatterColorFactor", {.5, .5, .5}}};
  expectScattering(extensionOf(material), vec3(.5f), 0);
}

TEST(GltfScatter, CoefficientsThemselves) {
  const MaterialExtension x = extensionOf(extras({{"scattering", {3, 2, 1}}, {"absorption", {.5, 0, 7}}}));
  for (int c = 0; c < 3; ++c) EXPECT_EQ(x.scattering[c], float(3 - c));
  EXPECT_EQ(x.absorption[0], .5f);
  EXPECT_EQ(x.absorption[1], 0.0f);
  EXPECT_EQ(x.absorption[2], 7.0f);
  const MaterialExtension half = extensionOf(extras({{"scattering", {3, 2, 1}}}));
  EXPECT_FLOAT_EQ(half.absorption[0], float(kAttenuation[0])) << "as without scattering";
}

TEST(GltfScatter, BlackIsAsDarkAsOneTenThousandth) {
  Json material = draft(Json::object());
  material["extensions"]["KHR_materials_volume"]["attenuationColor"] = {0, 1e-4, 1};
  const MaterialExtension x = extensionOf(material);
  EXPECT_FLOAT_EQ(x.absorption[0], float(-std::log(1e-4) / .1));
  EXPECT_EQ(x.absorption[0], x.absorption[1]);
  EXPECT_EQ(x.absorption[2], 0.0f);
}

TEST(GltfScatter, AThinWallHoldsNoMedium) {
  Json thin = draft({{"multiscatterColorFactor", {1, 1, 1}}});
  thin["extensions"]["KHR_materials_volume"].erase("thicknessFactor");
  const LogCapture capture;
  EXPECT_TRUE(sceneOf(thin).materialExtensions.empty());
  EXPECT_NE(
      capture.text().find("KHR_materials_volume_scatter: ignored: it needs KHR_materials_volume with a"),
      std::string::npos)
      << capture.text();
}

void expectSaid(const Json& material, const std::string& message) {
  const LogCapture capture;
  sceneOf(material);
  EXPECT_NE(capture.text().find(message), std::string::npos) << capture.text();
}

TEST(GltfScatter, WhatCannotBeSeenIsSaid) {
  const Json grey = {{"multiscatterColorFactor", {.5, .5, .5}}};
  expectSaid(draft(grey), "volume_scatter: has no effect: neither transmission nor diffuse transmission");
  expectSaid(draft(Json::object()), "volume_scatter: scatters nothing");
  Json empty = extras(grey);
  empty["extensions"]["KHR_materials_volume"].erase("attenuationDistance");
  expectSaid(empty, "extras.boxlight_scatter: scatters nothing");
  Json textured = draft(grey);
  textured["extensions"]["KHR_materials_volume_scatter"]["multiscatterColorTexture"] = {{"index", 0}};
  expectSaid(textured, "multiscatterColorTexture: ignored");
  for (const char* way : {"transmission", "diffuse_transmission"}) {
    Json whole = draft(grey);
    const std::string factor = way[0] == 't' ? "transmissionFactor" : "diffuseTransmissionFactor";
    whole["extensions"]["KHR_materials_" + std::string(way)][factor] = 1;
    const LogCapture capture;
    sceneOf(whole);
    EXPECT_EQ(capture.text(), "");
  }
}

TEST(GltfScatter, RangesAreClamped) {
  const LogCapture capture;
  EXPECT_FLOAT_EQ(extensionOf(draft({{"scatterAnisotropy", 1}})).scatterAnisotropy, .999f);
  EXPECT_FLOAT_EQ(extensionOf(draft({{"scatterAnisotropy", -2}})).scatterAnisotropy, -.999f);
  EXPECT_EQ(extensionOf(extras({{"scattering", {-1, 0, 0}}})).scattering[0], 0.0f);
  expectScattering(extensionOf(draft({{"multiscatterColorFactor", {2, -1, .5}}})), {1, 0, .5f}, 0);
  for (const char* place : {"volume_scatter.scatterAnisotropy: -2", "boxlight_scatter.scattering: -1",
                            "volume_scatter.multiscatterColorFactor: 2"})
    EXPECT_NE(capture.text().find(place), std::string::npos) << capture.text();
}

TEST(GltfScatter, WrongTypesAreInvalidWhereTheyAreOurs) {
  for (const char* member :
       {"multiscatterColorFactor", "multiscatterColor", "scatterAnisotropy", "scattering", "absorption"})
    for (const Json& material : {extras({{member, "text"}}), extras({{member, {1, 2}}})}) try {
        sceneOf(material);
        ADD_FAILURE() << material << " was loaded";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalidInput);
        const std::string place = std::string("materials[0].extras.boxlight_scatter.") + member;
        EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
      }
  EXPECT_THROW(sceneOf(extras(3)), Error);
  for (const Json& foreign : {Json(3), Json("text"), Json::array({1}), Json(), Json{{"other", 3}}})
    EXPECT_NO_THROW(sceneOf({{"extras", foreign}})) << foreign;
}

}  // namespace
}  // namespace boxlight::test
