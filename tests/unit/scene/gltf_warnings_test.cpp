// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "gltf_builder.h"
#include "log_capture.h"

namespace boxlight::test {
namespace {

// What the log says while a file is loaded.
std::string messagesOf(const GltfBuilder& builder) {
  const LogCapture capture;
  builder.load();
  return capture.text();
}

void expectSaid(const GltfBuilder& builder, std::initializer_list<std::string> expected) {
  const std::string messages = messagesOf(builder);
  for (const std::string& message : expected)
    EXPECT_NE(messages.find(message), std::string::npos) << messages;
}

TEST(GltfWarnings, NoneForAPlainFile) { EXPECT_EQ(messagesOf(oneTriangle()), ""); }

TEST(GltfWarnings, UnsupportedExtensionsInOneLine) {
  GltfBuilder builder = oneTriangle();
  builder.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_specular", "EXT_foo"};
  expectSaid(builder, {"extensionsUsed: not supported and therefore ignored: KHR_lights_punctual, EXT_foo"});
}

TEST(GltfWarnings, SkippedPrimitivesByName) {
  GltfBuilder builder = oneTriangle();
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
  expectSaid(
      builder,
      {"meshes[0].primitives[1], meshes[0].primitives[2]: points, lines or without POSITION; skipped"});
}

TEST(GltfWarnings, Motion) {
  GltfBuilder builder = oneTriangle();
  builder.json["skins"] = {{{"joints", {0}}}};
  builder.json["animations"] = Json::array({Json::object()});
  builder.primitive()["targets"] = {{{"POSITION", 0}}};
  expectSaid(builder, {"animations, skins, morph targets ignored"});
}

TEST(GltfWarnings, WhatWasMended) {
  GltfBuilder builder = oneTriangle();
  Json& primitive = builder.primitive();
  primitive["attributes"]["NORMAL"] = builder.addFloats("VEC3", {0, 0, 0, 0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = builder.addFloats("VEC4", {1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, -1});
  primitive["attributes"]["COLOR_0"] = builder.addFloats("VEC3", {1, 1, 1, 2, 1, 1, 1, 1, -1});
  primitive["indices"] = builder.addIndices<uint8_t>({0, 1, 2, 0, 0, 1});
  expectSaid(builder, {"1 normals of zero length", "w of 1 tangents", "2 colours clamped",
                       "1 triangles without area dropped"});
}

TEST(GltfWarnings, AnisotropyWithoutADirection) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["material"] =
      builder.add("materials", {{"extensions", {{"KHR_materials_anisotropy", {{"anisotropyStrength", 1}}}}}});
  expectSaid(builder, {"meshes[0].primitives[0]: anisotropic, but without TANGENT and TEXCOORD_0"});
}

TEST(GltfWarnings, SixteenBitImages) {
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.addTexture(png(1, 1, {1, 2, 3, 4}, 16));
  expectSaid(builder, {"images[0]: 16 bits per channel are rounded to 8"});
}

}  // namespace
}  // namespace boxlight::test
