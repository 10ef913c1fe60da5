// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_support.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bake/scene/gltf_error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// KHR_mesh_quantization only widens the component types of attributes (gltf_primitive.cpp);
// KHR_materials_volume_scatter is a draft (gltf_scatter.cpp).
constexpr std::string_view kSupported[] = {
    "KHR_materials_anisotropy",
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
    "KHR_texture_transform",
};

constexpr const char* kDecodeGeometry = "decode it first: npx @gltf-transform/cli copy IN.glb OUT.glb";
struct Conversion {
  std::string_view extension;
  const char* remedy;
};
constexpr Conversion kConversions[] = {
    {"KHR_draco_mesh_compression", kDecodeGeometry},
    {"EXT_meshopt_compression", kDecodeGeometry},
    {"KHR_meshopt_compression", kDecodeGeometry},
    {"KHR_texture_basisu",
     "turn its textures into PNG first: npx @gltf-transform/cli ktxdecompress IN.glb OUT.glb, with the ktx "
     "program of KTX-Software installed"},
    {"EXT_texture_webp",
     "turn its textures into PNG first: npx @gltf-transform/cli png IN.glb OUT.glb --formats webp"},
    {"EXT_texture_avif",
     "turn its textures into PNG first: npx @gltf-transform/cli png IN.glb OUT.glb --formats avif"},
};
constexpr std::string_view kMeshopt[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

std::vector<std::string> unsupportedExtensions(const fs::path& path, const Json& json, const char* key) {
  std::vector<std::string> names;
  const auto list = json.find(key);
  if (list == json.end()) return names;
  if (!list->is_array()) failAt(ExitCode::invalidInput, path, key, "must be an array");
  for (const Json& name : *list) {
    if (!name.is_string()) failAt(ExitCode::invalidInput, path, key, "must hold strings");
    const std::string& text = name.get_ref<const std::string&>();
    if (!isSupportedExtension(text)) names.push_back(text);
  }
  return names;
}

// The member of `object`.extensions, or null.
const Json* extensionOf(const Json& object, std::string_view name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(std::string(name));
  return found == extensions->end() ? nullptr : &*found;
}

void failCompressed(const fs::path& path, const std::string& place, std::string_view extension) {
  failAt(ExitCode::unsupported, path, place, "exists only compressed by {}; {}", extension,
         conversionOf(extension));
}

void checkPrimitives(const fs::path& path, const Json& json) {
  constexpr std::string_view kDraco = "KHR_draco_mesh_compression";
  const Json& meshes = json.value("meshes", Json::array());
  for (size_t m = 0; m < meshes.size(); ++m) {
    const Json& primitives = meshes[m]["primitives"];
    for (size_t p = 0; p < primitives.size(); ++p) {
      if (!extensionOf(primitives[p], kDraco)) continue;
      const auto check = [&](const Json& accessor, const std::string& name) {
        const Json& target = json["accessors"][accessor.get<size_t>()];
        if (!target.contains("bufferView") && !target.contains("sparse"))
          failCompressed(path, fmt::format("meshes[{}].primitives[{}].{}", m, p, name), kDraco);
      };
      for (const auto& [name, accessor] : primitives[p]["attributes"].items())
        check(accessor, "attributes." + name);
      if (primitives[p].contains("indices")) check(primitives[p]["indices"], "indices");
    }
  }
}

// A fallback buffer without a uri has no bytes (EXT_meshopt_compression, "Fallback buffers").
void checkFallbackBuffers(const fs::path& path, const Json& json) {
  const Json& buffers = json.value("buffers", Json::array());
  for (size_t i = 0; i < buffers.size(); ++i) {
    for (const std::string_view name : kMeshopt) {
      const Json* meshopt = extensionOf(buffers[i], name);
      if (meshopt && meshopt->is_object() && meshopt->value("fallback", Json()) == true &&
          !buffers[i].contains("uri"))
        failCompressed(path, fmt::format("buffers[{}]", i), name);
    }
  }
}

}  // namespace

bool isSupportedExtension(std::string_view name) {
  return std::ranges::find(kSupported, name) != std::end(kSupported);
}

const char* conversionOf(std::string_view extension) {
  for (const Conversion& conversion : kConversions)
    if (conversion.extension == extension) return conversion.remedy;
  return "export the file without it";
}

void checkExtensions(const fs::path& path, const Json& json) {
  const auto required = unsupportedExtensions(path, json, "extensionsRequired");
  if (!required.empty()) {
    std::vector<std::string> remedies;
    for (const std::string& name : required) {
      std::string remedy = conversionOf(name);
      if (std::ranges::find(remedies, remedy) == remedies.end()) remedies.push_back(std::move(remedy));
    }
    failAt(ExitCode::unsupported, path, "extensionsRequired", "not supported: {}; {}",
           fmt::join(required, ", "), fmt::join(remedies, "; "));
  }
  const auto used = unsupportedExtensions(path, json, "extensionsUsed");
  if (!used.empty()) {
    log().warn("{}: extensionsUsed: not supported and therefore ignored: {}", path.string(),
               fmt::join(used, ", "));
  }
}

void checkCompression(const fs::path& path, const Json& json) {
  checkPrimitives(path, json);
  checkFallbackBuffers(path, json);
}

}  // namespace boxlight
