// SPDX-License-Identifier: Apache-2.0
#include "gltf_builder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "bake/scene/gltf_load.h"

namespace boxlight::test {
namespace {

void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

void appendWord(Bytes& bytes, uint32_t value) {  // little-endian
  for (int i = 0; i < 4; ++i) bytes.push_back(uint8_t(value >> 8 * i));
}

Bytes bigEndian(uint32_t value) {
  return {uint8_t(value >> 24), uint8_t(value >> 16), uint8_t(value >> 8), uint8_t(value)};
}

uint32_t crc32(const Bytes& bytes) {
  uint32_t crc = ~0u;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  return ~crc;
}

void appendPngChunk(Bytes& file, const char* type, const Bytes& data) {
  append(file, bigEndian(uint32_t(data.size())));
  Bytes body(type, type + 4);
  append(body, data);
  append(file, body);
  append(file, bigEndian(crc32(body)));
}

// zlib with stored blocks (RFC 1950, 1951).
Bytes stored(const Bytes& data) {
  Bytes out = {0x78, 0x01};
  for (size_t at = 0; at < data.size();) {
    const size_t size = std::min<size_t>(data.size() - at, 65535);
    append(out, {uint8_t(at + size == data.size()), uint8_t(size), uint8_t(size >> 8), uint8_t(~size),
                 uint8_t(~size >> 8)});
    out.insert(out.end(), data.begin() + ptrdiff_t(at), data.begin() + ptrdiff_t(at + size));
    at += size;
  }
  uint32_t a = 1, b = 0;
  for (const uint8_t byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  append(out, bigEndian(b << 16 | a));
  return out;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "scene_test_XXXXXX").string();
  if (!::mkdtemp(pattern.data())) ADD_FAILURE() << "cannot make " << pattern;
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string base64(const Bytes& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = bytes.size() - i;
    const uint32_t bits =
        uint32_t(bytes[i]) << 16 | (left > 1 ? bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
    for (size_t k = 0; k < 4; ++k) text += k <= left ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

void writeBytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!file) ADD_FAILURE() << "cannot write " << path;
}

Bytes png(uint32_t width, uint32_t height, const std::vector<uint16_t>& samples, int bits) {
  EXPECT_EQ(samples.size(), size_t(width) * height * 4);
  Bytes rows;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (i % (size_t(width) * 4) == 0) rows.push_back(0);  // no filter
    if (bits == 16) rows.push_back(uint8_t(samples[i] >> 8));
    rows.push_back(uint8_t(samples[i]));
  }
  Bytes header = bigEndian(width);
  append(header, bigEndian(height));
  append(header, {uint8_t(bits), 6, 0, 0, 0});
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  appendPngChunk(file, "IHDR", header);
  appendPngChunk(file, "IDAT", stored(rows));
  appendPngChunk(file, "IEND", {});
  return file;
}

GltfBuilder::GltfBuilder() {
  json = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", Json::array({{{"nodes", Json::array()}}})}};
  json["buffers"] = Json::array({{{"byteLength", 0}}});
}

int GltfBuilder::add(const std::string& array, Json element) {
  json[array].push_back(std::move(element));
  return int(json[array].size()) - 1;
}

int GltfBuilder::addView(const Bytes& bytes, int byteStride) {
  while (binary.size() % 4) binary.push_back(0);
  Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
  if (byteStride) view["byteStride"] = byteStride;
  append(binary, bytes);
  json["buffers"][0]["byteLength"] = binary.size();
  return add("bufferViews", view);
}

int GltfBuilder::addAccessor(int view, int componentType, const std::string& type, size_t count,
                             const Json& more) {
  Json accessor = {{"componentType", componentType}, {"type", type}, {"count", count}};
  if (view >= 0) accessor["bufferView"] = view;
  accessor.update(more);
  return add("accessors", accessor);
}

int GltfBuilder::addFloats(const std::string& type, const std::vector<float>& values) {
  const size_t components = type == "SCALAR" ? 1 : size_t(type[3] - '0');
  return addAccessor(addView(bytesOf(values)), 5126, type, values.size() / components);
}

int GltfBuilder::addMesh(Json primitive) {
  const int mesh = add("meshes", {{"primitives", Json::array({std::move(primitive)})}});
  json["scenes"][0]["nodes"].push_back(add("nodes", {{"mesh", mesh}}));
  return mesh;
}

int GltfBuilder::addTexture(const Bytes& pngBytes, const Json& sampler) {
  const int image = add("images", {{"bufferView", addView(pngBytes)}, {"mimeType", "image/png"}});
  Json texture = {{"source", image}};
  if (!sampler.is_null()) texture["sampler"] = add("samplers", sampler);
  return add("textures", texture);
}

Bytes GltfBuilder::glb() const {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  Bytes data = binary;
  data.resize((data.size() + 3) / 4 * 4);
  Bytes file = {'g', 'l', 'T', 'F'};
  appendWord(file, 2);
  appendWord(file, uint32_t(12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size())));
  appendWord(file, uint32_t(text.size()));
  append(file, {'J', 'S', 'O', 'N'});
  file.insert(file.end(), text.begin(), text.end());
  if (data.empty()) return file;
  appendWord(file, uint32_t(data.size()));
  append(file, {'B', 'I', 'N', 0});
  append(file, data);
  return file;
}

void GltfBuilder::writeGlb(const std::filesystem::path& path) const { writeBytes(path, glb()); }

Scene GltfBuilder::load() const {
  const TemporaryFolder folder;
  writeGlb(folder / "scene.glb");
  return loadGltf(folder / "scene.glb");
}

GltfBuilder oneTriangle() {
  GltfBuilder builder;
  builder.addMesh({{"attributes", {{"POSITION", builder.addFloats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
  return builder;
}

GltfBuilder texturedSquare(const Json& material) {
  GltfBuilder builder;
  const Json attributes = {
      {"POSITION", builder.addFloats("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})},
      {"NORMAL", builder.addFloats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
      {"TEXCOORD_0", builder.addFloats("VEC2", {0, 1, 1, 1, 1, 0, 0, 0})},
  };
  const int indices = builder.addIndices<uint8_t>({0, 1, 2, 0, 2, 3});
  builder.addMesh(
      {{"attributes", attributes}, {"indices", indices}, {"material", builder.add("materials", material)}});
  return builder;
}

}  // namespace boxlight::test
