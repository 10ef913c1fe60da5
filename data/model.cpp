// SPDX-License-Identifier: Apache-2.0
#include "data/model.h"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <cstring>

#include "common/base/error.h"
#include "common/base/file.h"

namespace boxlight::data {
namespace {

using Json = nlohmann::ordered_json;

// glTF's and GLB's numbers (glTF 2.0 specification, 3.6.2 and 4.4).
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kNearest = 9728, kLinear = 9729;
constexpr uint32_t kGlbMagic = 0x46546C67, kGlbVersion = 2, kJsonChunk = 0x4E4F534A,
                   kBinaryChunk = 0x004E4942;

class GlbWriter {
 public:
  explicit GlbWriter(const Model& model) : model_(model) {
    root_["asset"] = {{"version", "2.0"}, {"generator", "boxlight_data " BOXLIGHT_VERSION}};
    root_["scene"] = 0;
    root_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    for (const Texture& texture : model.textures) addTexture(texture);
    for (const Part& part : model.parts) addPart(part);
    root_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
  }

  void save(const std::filesystem::path& path) {
    std::string text = root_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const uint32_t header[] = {kGlbMagic, kGlbVersion, uint32_t(28 + text.size() + binary_.size()),
                               uint32_t(text.size()), kJsonChunk};
    const uint32_t chunk[] = {uint32_t(binary_.size()), kBinaryChunk};
    AtomicFile file(path);
    file.write(std::as_bytes(std::span(header)));
    file.write(std::as_bytes(std::span(text)));
    file.write(std::as_bytes(std::span(chunk)));
    file.write(binary_);
    file.commit();
  }

 private:
  size_t addView(std::span<const std::byte> bytes, int target = 0) {
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (target) view["target"] = target;
    binary_.insert(binary_.end(), bytes.begin(), bytes.end());
    binary_.resize((binary_.size() + 3) / 4 * 4);
    root_["bufferViews"].push_back(view);
    return root_["bufferViews"].size() - 1;
  }

  size_t addAccessor(Json accessor) {
    root_["accessors"].push_back(std::move(accessor));
    return root_["accessors"].size() - 1;
  }

  template <class Vector>
  size_t addVectors(const std::vector<Vector>& values) {
    constexpr int kLength = Vector::length();
    Json accessor = {{"bufferView", addView(std::as_bytes(std::span(values)), kArrayBuffer)},
                     {"componentType", kFloat},
                     {"count", values.size()},
                     {"type", kLength == 2 ? "VEC2" : "VEC3"}};
    Vector low(values[0]), high(values[0]);
    for (const Vector& value : values) low = glm::min(low, value), high = glm::max(high, value);
    for (int k = 0; k < kLength; ++k) accessor["min"].push_back(low[k]), accessor["max"].push_back(high[k]);
    return addAccessor(accessor);
  }

  size_t addIndices(const std::vector<uint32_t>& indices) {
    return addAccessor({{"bufferView", addView(std::as_bytes(std::span(indices)), kElementArrayBuffer)},
                        {"componentType", kUnsignedInt},
                        {"count", indices.size()},
                        {"type", "SCALAR"}});
  }

  void addTexture(const Texture& texture) {
    std::vector<std::byte> png;
    auto append = [](void* context, void* data, int size) {
      auto* target = static_cast<std::vector<std::byte>*>(context);
      const auto* bytes = static_cast<const std::byte*>(data);
      target->insert(target->end(), bytes, bytes + size);
    };
    const int width = int(texture.width), height = int(texture.height);
    if (!stbi_write_png_to_func(append, &png, width, height, 4, texture.rgba.data(), width * 4))
      fail(ExitCode::runtime, "cannot encode a {}x{} texture as PNG", width, height);
    const Json image = {{"bufferView", addView(png)}, {"mimeType", "image/png"}};
    root_["images"].push_back(image);
    const int filter = texture.nearest ? kNearest : kLinear;
    const Json sampler = {{"magFilter", filter}, {"minFilter", filter}};
    root_["samplers"].push_back(sampler);
    const size_t index = root_["images"].size() - 1;
    const Json reference = {{"source", index}, {"sampler", index}};
    root_["textures"].push_back(reference);
  }

  /// Notes the names of extensions in use, each once.
  void use(const std::string& extension) {
    Json& used = root_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
  }

  void setTexture(Json& owner, const char* key, int texture, const Material& material) {
    if (texture < 0) return;
    owner[key] = {{"index", texture}};
    if (material.textureTransform.is_null()) return;
    owner[key]["extensions"]["KHR_texture_transform"] = material.textureTransform;
    use("KHR_texture_transform");
  }

  size_t addMaterial(const Material& material) {
    Json metalRough = {{"baseColorFactor",
                        {material.baseColor.x, material.baseColor.y, material.baseColor.z, material.alpha}},
                       {"metallicFactor", material.metallic},
                       {"roughnessFactor", material.roughness}};
    setTexture(metalRough, "baseColorTexture", material.baseColorTexture, material);
    setTexture(metalRough, "metallicRoughnessTexture", material.metallicRoughnessTexture, material);
    Json json = {{"name", material.name}, {"pbrMetallicRoughness", metalRough}};
    setTexture(json, "normalTexture", material.normalTexture, material);
    if (material.emissive != Rgb(0.0f))
      json["emissiveFactor"] = {material.emissive.x, material.emissive.y, material.emissive.z};
    if (material.doubleSided) json["doubleSided"] = true;
    if (material.alphaMode != "OPAQUE") json["alphaMode"] = material.alphaMode;
    if (material.specular != 1)
      json["extensions"]["KHR_materials_specular"]["specularFactor"] = material.specular;
    for (const auto& [name, extension] : material.extensions.items()) json["extensions"][name] = extension;
    if (json.contains("extensions"))
      for (const auto& [name, extension] : json["extensions"].items()) use(name);
    root_["materials"].push_back(json);
    return root_["materials"].size() - 1;
  }

  void addPart(const Part& part) {
    Chart all;
    for (const Chart& chart : part.charts) appendChart(all, chart);
    Json attributes = {{"POSITION", addVectors(all.positions)}, {"NORMAL", addVectors(all.normals)}};
    attributes["TEXCOORD_0"] = addVectors(model_.textured ? all.texcoords : all.atlas);
    if (model_.textured) attributes["TEXCOORD_1"] = addVectors(all.atlas);
    const Json primitive = {{"attributes", attributes},
                            {"indices", addIndices(all.indices)},
                            {"material", addMaterial(part.material)}};
    const Json mesh = {{"name", part.name}, {"primitives", Json::array({primitive})}};
    root_["meshes"].push_back(mesh);
    const size_t index = root_["meshes"].size() - 1;
    const Json node = {{"name", part.name}, {"mesh", index}};
    root_["nodes"].push_back(node);
    root_["scenes"][0]["nodes"].push_back(index);
  }

  const Model& model_;
  Json root_;
  std::vector<std::byte> binary_;
};

}  // namespace

void packModel(Model& model) {
  std::vector<Chart*> charts;
  for (Part& part : model.parts)
    for (Chart& chart : part.charts) charts.push_back(&chart);
  packCharts(charts);
}

void writeGlb(const std::filesystem::path& path, const Model& model) { GlbWriter(model).save(path); }

}  // namespace boxlight::data
