// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bake/scene/scene.h"

namespace boxlight::test {

using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;

/// A folder of its own for one test, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

template <class T>
Bytes bytesOf(const std::vector<T>& values) {
  const auto* first = reinterpret_cast<const uint8_t*>(values.data());
  return Bytes(first, first + values.size() * sizeof(T));
}

std::string base64(const Bytes& bytes);
void writeBytes(const std::filesystem::path& path, const Bytes& bytes);

/// An RGBA PNG of 8 or 16 bits per channel, not compressed. `samples` has four per pixel; row 0 is the top.
Bytes png(uint32_t width, uint32_t height, const std::vector<uint16_t>& samples, int bits = 8);

/// Writes small glTF files. Everything that it makes stands in `json`, where a test may change or damage it.
struct GltfBuilder {
  GltfBuilder();

  int addView(const Bytes& bytes, int byteStride = 0);
  int addAccessor(int view, int componentType, const std::string& type, size_t count,
                  const Json& more = Json::object());
  int addFloats(const std::string& type, const std::vector<float>& values);
  template <class T>
  int addIndices(const std::vector<T>& indices) {
    constexpr int kType = sizeof(T) == 1 ? 5121 : sizeof(T) == 2 ? 5123 : 5125;
    return addAccessor(addView(bytesOf(indices)), kType, "SCALAR", indices.size());
  }
  /// Appends to json[array] and returns the index.
  int add(const std::string& array, Json element);
  /// A mesh of one primitive, and a node of the default scene that shows it; returns the mesh's index.
  int addMesh(Json primitive);
  /// A PNG in the BIN chunk, an image and a texture of it; returns the texture's index.
  int addTexture(const Bytes& pngBytes, const Json& sampler = Json());

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }

  Bytes glb() const;  ///< the document as it stands, and the BIN chunk
  void writeGlb(const std::filesystem::path& path) const;
  Scene load() const;  ///< by way of a temporary .glb

  Json json;
  Bytes binary;
};

/// A builder with one triangle (0,0,0) (1,0,0) (0,1,0): POSITION is accessor 0, indices none.
GltfBuilder oneTriangle();

/// A unit square in the plane z = 0, facing +Z, with normals and a TEXCOORD_0 that shows an image upright;
/// material 0. Vertices: lower left, lower right, upper right, upper left.
GltfBuilder texturedSquare(const Json& material);

}  // namespace boxlight::test
