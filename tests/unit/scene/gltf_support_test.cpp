// SPDX-License-Identifier: Apache-2.0
// What a file may ask for, and what is said where it asks for too much.
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "gltf_builder.h"
#include "log_capture.h"

namespace boxlight::test {
namespace {

constexpr const char* kSupported[] = {"KHR_materials_anisotropy",
                                      "KHR_materials_clearcoat",
                                      "KHR_materials_diffuse_transmission",
                                      "KHR_materials_emissive_strength",
                                      "KHR_materials_ior",
                                      "KHR_materials_iridescence",
                                      "KHR_materials_sheen",
                                      "KHR_materials_specular",
                                      "KHR_materials_transmission",
                                      "KHR_materials_unlit",
                                      "KHR_materials_volume",
                                      "KHR_materials_volume_scatter",
                                      "KHR_mesh_quantization",
                                      "KHR_texture_transform"};

void expectUnsupported(const GltfBuilder& builder, std::initializer_list<std::string> parts) {
  try {
    builder.load();
    ADD_FAILURE() << "was loaded";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::unsupported) << error.what();
    for (const std::string& part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " in: " << error.what();
  }
}

TEST(GltfSupport, SupportedOnesMayBeRequired) {
  for (const char* name : kSupported) {
    GltfBuilder builder = oneTriangle();
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {name};
    const LogCapture capture;
    EXPECT_NO_THROW(builder.load()) << name;
    EXPECT_EQ(capture.text(), "");
  }
}

TEST(GltfSupport, OthersAreNamedInOneWarning) {
  GltfBuilder builder = oneTriangle();
  builder.json["extensionsUsed"] = {"KHR_materials_dispersion", "KHR_materials_ior",
                                    "KHR_materials_pbrSpecularGlossiness"};
  const LogCapture capture;
  builder.load();
  EXPECT_NE(capture.text().find("not supported and therefore ignored: KHR_materials_dispersion, "
                                "KHR_materials_pbrSpecularGlossiness\n"),
            std::string::npos)
      << capture.text();
}

TEST(GltfSupport, RequiredOnesComeWithTheCommandThatConverts) {
  const std::pair<const char*, const char*> cases[] = {
      {"KHR_draco_mesh_compression", "npx @gltf-transform/cli copy "},
      {"EXT_meshopt_compression", "npx @gltf-transform/cli copy "},
      {"KHR_texture_basisu", "npx @gltf-transform/cli ktxdecompress "},
      {"EXT_texture_webp", "npx @gltf-transform/cli png IN.glb OUT.glb --formats webp"},
      {"KHR_materials_pbrSpecularGlossiness", "export the file without it"}};
  for (const auto& [name, command] : cases) {
    GltfBuilder builder = oneTriangle();
    builder.json["extensionsRequired"] = {name};
    expectUnsupported(builder, {"extensionsRequired: not supported: ", name, command});
  }
  GltfBuilder builder = oneTriangle();
  builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression", "KHR_texture_basisu"};
  expectUnsupported(builder,
                    {"KHR_draco_mesh_compression, KHR_texture_basisu", "cli copy ", "ktxdecompress "});
}

TEST(GltfSupport, DracoThatNobodyRequires) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  EXPECT_NO_THROW(builder.load()) << "the attributes are there as well";
  builder.json["accessors"][0].erase("bufferView");
  expectUnsupported(builder, {"meshes[0].primitives[0].attributes.POSITION", "KHR_draco_mesh_compression",
                              "npx @gltf-transform/cli copy "});
}

TEST(GltfSupport, DracoIndicesThatNobodyRequires) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["indices"] = builder.addIndices<uint16_t>({0, 1, 2});
  builder.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  builder.json["accessors"][1].erase("bufferView");
  expectUnsupported(builder, {"meshes[0].primitives[0].indices", "KHR_draco_mesh_compression"});
}

TEST(GltfSupport, MeshoptFallbackBuffersWithoutBytes) {
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    GltfBuilder builder = oneTriangle();
    builder.json["buffers"].push_back({{"byteLength", 36}, {"extensions", {{name, {{"fallback", true}}}}}});
    builder.json["bufferViews"][0]["extensions"][name] = {{"buffer", 0}};
    builder.json["bufferViews"][0]["buffer"] = 1;
    builder.json["bufferViews"][0]["byteOffset"] = 0;
    expectUnsupported(builder, {"buffers[1]", name, "npx @gltf-transform/cli copy "});
    builder.json["buffers"][1]["uri"] = "data:application/octet-stream;base64," + base64(builder.binary);
    EXPECT_NO_THROW(builder.load()) << "the fallback has its bytes";
  }
}

GltfBuilder withTexture() {
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  return builder;
}

TEST(GltfSupport, TexturesOfOtherKindsOnly) {
  const std::pair<const char*, const char*> cases[] = {{"KHR_texture_basisu", "cli ktxdecompress "},
                                                       {"EXT_texture_webp", "--formats webp"},
                                                       {"MSFT_texture_dds", "export the file without it"}};
  for (const auto& [name, command] : cases) {
    GltfBuilder builder = withTexture();
    builder.json["textures"][0] = {{"extensions", {{name, {{"source", 0}}}}}};
    expectUnsupported(
        builder, {"baseColorTexture: textures[0] has no PNG or JPEG image, only that of ", name, command});
  }
}

TEST(GltfSupport, TexturesOfOtherKindsBesidePng) {
  GltfBuilder builder = withTexture();
  const int ktx = builder.add("images", {{"uri", "data:image/ktx2;base64,AAAA"}});
  builder.json["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = ktx;
  EXPECT_EQ(builder.load().textures.size(), 1u);
}

}  // namespace
}  // namespace boxlight::test
