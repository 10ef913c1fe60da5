// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "bake/scene/gltf_load.h"
#include "gltf_builder.h"

namespace boxlight::test {
namespace {

void writeGltf(const std::filesystem::path& path, const Json& json) {
  const std::string text = json.dump();
  writeBytes(path, Bytes(text.begin(), text.end()));
}

TEST(GltfContainer, EveryKindOfBufferGivesTheSameScene) {
  const TemporaryFolder folder;
  GltfBuilder builder = oneTriangle();
  builder.writeGlb(folder / "embedded.glb");
  const Scene embedded = loadGltf(folder / "embedded.glb");
  EXPECT_EQ(embedded.triangles.size(), 1u);
  EXPECT_EQ(embedded.boundsMin, vec3(0, 0, 0));
  EXPECT_EQ(embedded.boundsMax, vec3(1, 1, 0));

  builder.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(builder.binary);
  writeGltf(folder / "data.gltf", builder.json);
  EXPECT_EQ(loadGltf(folder / "data.gltf").hash, embedded.hash);

  builder.json["buffers"][0]["uri"] = "my%20data+1.bin";
  writeBytes(folder / "my data+1.bin", builder.binary);
  writeGltf(folder / "external.gltf", builder.json);
  EXPECT_EQ(loadGltf(folder / "external.gltf").hash, embedded.hash);
}

TEST(GltfContainer, SourcesMayHoldMoreThanDeclared) {
  const TemporaryFolder folder;
  GltfBuilder builder = oneTriangle();
  const uint64_t hash = builder.load().hash;
  builder.binary.resize(builder.binary.size() + 5);
  builder.json["buffers"][0]["uri"] = "data:application/gltf-buffer;base64," + base64(builder.binary);
  writeGltf(folder / "data.gltf", builder.json);
  EXPECT_EQ(loadGltf(folder / "data.gltf").hash, hash);
  builder.json["buffers"][0]["uri"] = "a.bin";
  writeBytes(folder / "a.bin", builder.binary);
  writeGltf(folder / "external.gltf", builder.json);
  EXPECT_EQ(loadGltf(folder / "external.gltf").hash, hash);
}

TEST(GltfContainer, EveryKindOfImageGivesTheSameTexels) {
  const TemporaryFolder folder;
  const Bytes image = png(2, 1, {255, 0, 0, 255, 0, 255, 0, 128});
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.addTexture(image);
  const Scene embedded = builder.load();
  EXPECT_EQ(embedded.texels, (std::vector<uint32_t>{0xFF0000FFu, 0x8000FF00u}));

  builder.json["images"][0] = {{"uri", "data:image/png;base64," + base64(image)}};
  EXPECT_EQ(builder.load().hash, embedded.hash);

  builder.json["images"][0] = {{"uri", "red%2Dgreen.png"}};
  writeBytes(folder / "red-green.png", image);
  builder.writeGlb(folder / "external.glb");
  EXPECT_EQ(loadGltf(folder / "external.glb").hash, embedded.hash);
}

TEST(GltfContainer, UnknownChunksAreSkipped) {
  const TemporaryFolder folder;
  Bytes file = oneTriangle().glb();
  const Bytes chunk = {4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
  file.insert(file.end(), chunk.begin(), chunk.end());
  const uint32_t size = uint32_t(file.size());
  for (size_t i = 0; i < 4; ++i) file[8 + i] = uint8_t(size >> 8 * i);
  writeBytes(folder / "a.glb", file);
  EXPECT_EQ(loadGltf(folder / "a.glb").triangles.size(), 1u);
}

TEST(GltfContainer, AnimationsCamerasAndLightsDoNotDisturb) {
  GltfBuilder builder = oneTriangle();
  const uint64_t hash = builder.load().hash;
  builder.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"path", "pointer"}}}}}}, {"samplers", {1}}}};
  builder.json["cameras"] = {{{"type", "unknown"}}};
  builder.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_anything"};
  builder.json["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "spot"}}}}}}};
  EXPECT_EQ(builder.load().hash, hash);
}

TEST(GltfContainer, HashFollowsTheContent) {
  GltfBuilder builder = oneTriangle();
  const uint64_t hash = builder.load().hash;
  EXPECT_EQ(builder.load().hash, hash);
  builder.json["materials"] = {{{"doubleSided", true}}};
  builder.primitive()["material"] = 0;
  EXPECT_NE(builder.load().hash, hash);
}

}  // namespace
}  // namespace boxlight::test
