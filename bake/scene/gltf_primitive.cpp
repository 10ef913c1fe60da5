// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_primitive.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "bake/scene/gltf_accessor.h"
#include "bake/scene/gltf_error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

// Component types of attributes, as bits. Integers are of 8 or 16 bits.
enum ComponentTypes : uint32_t {
  kFloat = 1,
  kUnsignedNormalized = 2,
  kSignedNormalized = 4,
  kUnsigned = 8,
  kSigned = 16,
  kAnyInteger = kUnsignedNormalized | kSignedNormalized | kUnsigned | kSigned,
};

// What glTF 2.0 (section 3.7.2.1) allows for an attribute, and what KHR_mesh_quantization adds.
struct Attribute {
  const char* name;
  int minComponents, maxComponents;
  uint32_t types, quantizedTypes;
};
constexpr Attribute kPosition = {"POSITION", 3, 3, kFloat, kAnyInteger};
constexpr Attribute kNormal = {"NORMAL", 3, 3, kFloat, kSignedNormalized};
constexpr Attribute kTangent = {"TANGENT", 4, 4, kFloat, kSignedNormalized};
constexpr Attribute kTexcoord[2] = {{"TEXCOORD_0", 2, 2, kFloat | kUnsignedNormalized, kAnyInteger},
                                    {"TEXCOORD_1", 2, 2, kFloat | kUnsignedNormalized, kAnyInteger}};
constexpr Attribute kColor = {"COLOR_0", 3, 4, kFloat | kUnsignedNormalized, 0};

uint32_t componentTypeOf(const AccessorReader& reader) {
  switch (reader.componentType()) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return kFloat;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return reader.normalized() ? kUnsignedNormalized : kUnsigned;
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return reader.normalized() ? kSignedNormalized : kSigned;
    default:
      return 0;
  }
}

bool isIndexType(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

class PrimitiveReader {
 public:
  PrimitiveReader(const GltfDocument& file, int mesh, size_t primitive)
      : file_(file),
        primitive_(file.model.meshes[size_t(mesh)].primitives[primitive]),
        place_(primitivePlace(mesh, primitive)),
        quantized_(std::ranges::count(file.model.extensionsUsed, "KHR_mesh_quantization") > 0) {}

  Mesh read() {
    Mesh mesh;
    vertexCount_ = open(kPosition)->count();
    mesh.triangles = triangles(corners());
    used_ = compactIndices(mesh.triangles, vertexCount_);
    mesh.vertices.resize(used_.size(), asset::Vertex{.color = {1, 1, 1, 1}});
    readEach(kPosition, mesh, [](asset::Vertex& v, vec4 p) { store(v.position, dvec3(p)); });
    readTexcoords(mesh);
    readColors(mesh);
    const bool hasNormals =
        readEach(kNormal, mesh, [](asset::Vertex& v, vec4 n) { store(v.normal, normalizeOrZero(dvec3(n))); });
    if (hasNormals) {
      readTangents(mesh);
    } else {
      computeFlatNormals(mesh);
    }
    return mesh;
  }

 private:
  // The accessor of an attribute, its type checked; nothing if the primitive has none.
  std::optional<AccessorReader> open(const Attribute& attribute) const {
    const auto found = primitive_.attributes.find(attribute.name);
    if (found == primitive_.attributes.end()) return std::nullopt;
    AccessorReader reader(file_, found->second, fmt::format("{}.attributes.{}", place_, attribute.name));
    const uint32_t types = attribute.types | (quantized_ ? attribute.quantizedTypes : 0);
    const bool fits =
        reader.components() >= attribute.minComponents && reader.components() <= attribute.maxComponents;
    if (!fits || !(componentTypeOf(reader) & types)) {
      failAt(ExitCode::invalidInput, file_.path, reader.place(),
             "{} components of type {}{} are not allowed here; export the file again", reader.components(),
             reader.componentType(), reader.normalized() ? " (normalized)" : "");
    }
    return reader;
  }

  // Calls set(vertex, value) for every vertex; false if the primitive has no such attribute.
  template <class Set>
  bool readEach(const Attribute& attribute, Mesh& mesh, Set set) const {
    const auto reader = open(attribute);
    if (!reader) return false;
    if (reader->count() != vertexCount_) {
      failAt(ExitCode::invalidInput, file_.path, reader->place(),
             "has {} elements, POSITION has {}; export the file again", reader->count(), vertexCount_);
    }
    for (size_t i = 0; i < used_.size(); ++i) set(mesh.vertices[i], reader->floats(used_[i]));
    return true;
  }

  void readTexcoords(Mesh& mesh) const {
    for (int set = 0; set < 2; ++set) {
      mesh.hasTexcoord[set] = readEach(kTexcoord[set], mesh, [set](asset::Vertex& v, vec4 uv) {
        v.uv[set][0] = uv.x;
        v.uv[set][1] = uv.y;
      });
    }
  }

  // The specification wants colours clamped to [0,1]; beyond it they would make energy.
  void readColors(Mesh& mesh) const {
    const auto reader = open(kColor);
    const bool hasAlpha = reader && reader->components() == 4;
    size_t clamped = 0;
    readEach(kColor, mesh, [&](asset::Vertex& v, vec4 color) {
      if (!hasAlpha) color.w = 1.0f;
      const vec4 inRange = glm::clamp(color, 0.0f, 1.0f);
      clamped += inRange != color;
      for (int i = 0; i < 4; ++i) v.color[i] = inRange[i];
    });
    if (clamped > 0) {
      log().warn("{}: {}: {} colours clamped to [0,1]", file_.path.string(), reader->place(), clamped);
    }
  }

  void readTangents(Mesh& mesh) const {
    size_t unsignedOnes = 0;
    mesh.hasTangents = readEach(kTangent, mesh, [&](asset::Vertex& v, vec4 t) {
      store(v.tangent, normalizeOrZero(dvec3(t)));
      unsignedOnes += std::abs(t.w) != 1.0f;
      v.tangent[3] = t.w < 0.0f ? -1.0f : 1.0f;
    });
    if (unsignedOnes > 0) {
      log().warn("{}: {}.attributes.TANGENT: w of {} tangents is not 1 or -1; its sign is taken",
                 file_.path.string(), place_, unsignedOnes);
    }
  }

  // The vertex of each corner, by way of the indices if there are any.
  std::vector<uint32_t> corners() const {
    std::vector<uint32_t> corners;
    if (primitive_.indices < 0) {
      corners.resize(vertexCount_);
      std::iota(corners.begin(), corners.end(), 0u);
      return corners;
    }
    const AccessorReader indices(file_, primitive_.indices, place_ + ".indices");
    if (indices.components() != 1 || indices.normalized() || !isIndexType(indices.componentType())) {
      failAt(ExitCode::invalidInput, file_.path, indices.place(),
             "must be scalars of an unsigned integer type; export the file again");
    }
    corners.resize(indices.count());
    for (uint32_t i = 0; i < corners.size(); ++i) {
      corners[i] = indices.integer(i);
      if (corners[i] >= vertexCount_) {
        failAt(ExitCode::invalidInput, file_.path, indices.place(),
               "index {} at {} is out of range: there are {} vertices; export the file again", corners[i], i,
               vertexCount_);
      }
    }
    return corners;
  }

  // Strips and fans in the order of glTF 2.0, section 3.7.2.1.
  std::vector<uvec3> triangles(const std::vector<uint32_t>& v) const {
    const bool list = primitive_.mode == TINYGLTF_MODE_TRIANGLES;
    if (v.size() < 3 || (list && v.size() % 3 != 0)) {
      failAt(ExitCode::invalidInput, file_.path, place_,
             "{} corners make no triangles of mode {}; export the file again", v.size(), primitive_.mode);
    }
    std::vector<uvec3> result;
    result.reserve(list ? v.size() / 3 : v.size() - 2);
    if (list) {
      for (size_t i = 0; i < v.size(); i += 3) result.emplace_back(v[i], v[i + 1], v[i + 2]);
    } else if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (size_t i = 0; i + 2 < v.size(); ++i) result.emplace_back(v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]);
    } else {
      for (size_t i = 0; i + 2 < v.size(); ++i) result.emplace_back(v[i + 1], v[i + 2], v[0]);
    }
    return result;
  }

  const GltfDocument& file_;
  const tinygltf::Primitive& primitive_;
  const std::string place_;
  const bool quantized_;
  uint32_t vertexCount_ = 0;    // of the attributes
  std::vector<uint32_t> used_;  // those of them that triangles use
};

}  // namespace

std::string primitivePlace(int mesh, size_t primitive) {
  return fmt::format("meshes[{}].primitives[{}]", mesh, primitive);
}

Mesh readPrimitive(const GltfDocument& file, int mesh, size_t primitive) {
  return PrimitiveReader(file, mesh, primitive).read();
}

}  // namespace boxlight
