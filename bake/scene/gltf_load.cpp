// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_load.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>

#include "bake/scene/gltf_error.h"
#include "bake/scene/gltf_material.h"
#include "bake/scene/gltf_nodes.h"
#include "bake/scene/gltf_primitive.h"
#include "bake/scene/tangents.h"
#include "common/asset/texture_references.h"
#include "common/base/file.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

// Things that a bake of a static object leaves out.
void warnOfMotion(const GltfDocument& file) {
  std::vector<std::string> found;
  for (const char* key : {"animations", "skins"}) {
    if (file.json.contains(key)) found.emplace_back(key);
  }
  const auto hasTargets = [](const tinygltf::Primitive& p) { return !p.targets.empty(); };
  const bool morphs = std::ranges::any_of(file.model.meshes, [&](const tinygltf::Mesh& m) {
    return std::ranges::any_of(m.primitives, hasTargets);
  });
  if (morphs) found.emplace_back("morph targets");
  if (!found.empty()) {
    log().warn("{}: {} ignored: meshes are taken as they are stored", file.path.string(),
               fmt::join(found, ", "));
  }
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const GltfDocument& file) : file_(file), materials_(file, scene_) {}

  Scene build() {
    scene_.path = file_.path;
    scene_.hasTexcoord[0] = scene_.hasTexcoord[1] = true;
    for (const MeshInstance& instance : collectInstances(file_)) {
      const size_t count = file_.model.meshes[size_t(instance.mesh)].primitives.size();
      for (size_t p = 0; p < count; ++p) add(instance, p);
    }
    report();
    if (scene_.triangles.empty()) {
      failAt(ExitCode::invalidInput, file_.path, "scene", "shows no triangle; check what was exported");
    }
    finish();
    return std::move(scene_);
  }

 private:
  void add(const MeshInstance& instance, size_t index) {
    const tinygltf::Primitive& primitive = file_.model.meshes[size_t(instance.mesh)].primitives[index];
    const std::string place = primitivePlace(instance.mesh, index);
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES || !primitive.attributes.contains("POSITION")) {
      notSurfaces_.emplace(instance.mesh, index);
      return;
    }
    Mesh mesh = readPrimitive(file_, instance.mesh, index);
    const uint32_t material = materials_.find(primitive.material);
    checkTexcoords(mesh, material, place);
    if (!mesh.hasTangents) addTangents(mesh, material, place);

    const Placement placement = placeMesh(mesh, instance.toWorld);
    if (placement.outOfRange) {
      failAt(ExitCode::invalidInput, file_.path, place + ".attributes.POSITION",
             "nodes[{}] puts it beyond 1e18 m; scale the scene down", instance.node);
    }
    droppedTriangles_ += placement.droppedTriangles;
    replacedNormals_ += placement.replacedNormals;
    setTexelScale(instance.texelScale);
    append(mesh, material, place);
  }

  /// Of the triangles from here on.
  void setTexelScale(float scale) {
    const float last = scene_.texelScales.empty() ? 1.0f : scene_.texelScales.back().scale;
    if (scale != last) scene_.texelScales.push_back({uint32_t(scene_.triangles.size()), scale});
  }

  asset::MaterialExtension extensionOf(uint32_t material) const {
    return scene_.materialExtensions.empty() ? asset::MaterialExtension()
                                             : scene_.materialExtensions[material];
  }

  void checkTexcoords(const Mesh& mesh, uint32_t material, const std::string& place) const {
    const auto check = [&](const char* name, const asset::TextureRef& ref) {
      if (ref.texture == asset::kNone || mesh.hasTexcoord[ref.texcoord]) return;
      failAt(ExitCode::invalidInput, file_.path,
             fmt::format("{}.attributes.TEXCOORD_{}", place, ref.texcoord),
             "missing, but the {} of its material reads it; unwrap the mesh or remove the texture", name);
    };
    asset::forEachReference(scene_.materials[material], check);
    asset::forEachReference(extensionOf(material), check);
  }

  // Where something needs them. Of textures that read different sets, the first below has its way.
  void addTangents(Mesh& mesh, uint32_t material, const std::string& place) {
    const asset::MaterialExtension extension = extensionOf(material);
    for (const asset::TextureRef& ref :
         {extension.anisotropyTexture, scene_.materials[material].normalTexture,
          extension.clearcoatNormalTexture})
      if (ref.texture != asset::kNone) return computeTangents(mesh, ref.texcoord);
    if (extension.anisotropy == 0.0f) return;
    if (mesh.hasTexcoord[0] || mesh.hasTexcoord[1]) return computeTangents(mesh, mesh.hasTexcoord[0] ? 0 : 1);
    withoutTangents_.insert(place);
  }

  void append(const Mesh& mesh, uint32_t material, const std::string& place) {
    constexpr size_t kMax = std::numeric_limits<uint32_t>::max();
    const size_t first = scene_.vertices.size();
    if (first + mesh.vertices.size() >= kMax || scene_.triangles.size() + mesh.triangles.size() >= kMax) {
      failAt(ExitCode::unsupported, file_.path, place,
             "the scene passes 2^32 vertices or triangles; split it");
    }
    if (mesh.triangles.empty()) return;
    scene_.vertices.insert(scene_.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const uvec3& t : mesh.triangles) {
      const uint32_t base = uint32_t(first);
      scene_.triangles.push_back({.vertex = {base + t.x, base + t.y, base + t.z}, .material = material});
    }
    for (int set = 0; set < 2; ++set) scene_.hasTexcoord[set] &= mesh.hasTexcoord[set];
  }

  void report() const {
    const std::string path = file_.path.string();
    if (!notSurfaces_.empty()) {
      constexpr size_t kNamed = 8;
      std::vector<std::string> names;
      for (const auto& [mesh, primitive] : notSurfaces_) {
        if (names.size() < kNamed) names.push_back(primitivePlace(mesh, primitive));
      }
      const size_t more = notSurfaces_.size() - names.size();
      log().warn("{}: {}{}: points, lines or without POSITION; skipped", path, fmt::join(names, ", "),
                 more > 0 ? fmt::format(" and {} more", more) : "");
    }
    if (!withoutTangents_.empty()) {
      log().warn("{}: {}: anisotropic, but without TANGENT and TEXCOORD_0: its direction is arbitrary", path,
                 fmt::join(withoutTangents_, ", "));
    }
    if (droppedTriangles_ > 0) log().debug("{}: {} triangles without area dropped", path, droppedTriangles_);
    if (replacedNormals_ > 0) {
      log().warn("{}: {} normals of zero length replaced by the face's", path, replacedNormals_);
    }
  }

  void finish() {
    scene_.boundsMin = vec3(std::numeric_limits<float>::max());
    scene_.boundsMax = -scene_.boundsMin;
    for (const asset::Vertex& v : scene_.vertices) {
      const vec3 p(v.position[0], v.position[1], v.position[2]);
      scene_.boundsMin = glm::min(scene_.boundsMin, p);
      scene_.boundsMax = glm::max(scene_.boundsMax, p);
    }
    const auto hash = [this](const auto& array) {
      scene_.hash = xxh64(std::as_bytes(std::span(array)), scene_.hash ^ uint64_t(array.size()));
    };
    hash(scene_.vertices);
    hash(scene_.triangles);
    hash(scene_.materials);
    // Scenes without them keep their hash.
    if (!scene_.materialExtensions.empty()) hash(scene_.materialExtensions);
    if (!scene_.textureTransforms.empty()) hash(scene_.textureTransforms);
    hash(scene_.textures);
    hash(scene_.texels);
    if (!scene_.texelScales.empty()) hash(scene_.texelScales);
  }

  const GltfDocument& file_;
  Scene scene_;
  GltfMaterials materials_;
  std::set<std::pair<int, size_t>> notSurfaces_;  // mesh, primitive
  std::set<std::string> withoutTangents_;         // primitives
  size_t droppedTriangles_ = 0, replacedNormals_ = 0;
};

}  // namespace

Scene loadGltf(const std::filesystem::path& path) {
  const GltfDocument file = readGltf(path);
  warnOfMotion(file);
  return SceneBuilder(file).build();
}

}  // namespace boxlight
