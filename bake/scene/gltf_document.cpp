// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_document.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bake/scene/gltf_check.h"
#include "bake/scene/gltf_container.h"
#include "bake/scene/gltf_error.h"
#include "bake/scene/gltf_support.h"

namespace boxlight {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

void checkVersion(const fs::path& path, const Json& json) {
  const Json asset = json.value("asset", Json());
  const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
  if (!version.is_string())
    failAt(ExitCode::invalidInput, path, "asset.version", "missing; this is no glTF file");
  const Json needed = asset.value("minVersion", version);
  for (const Json& v : {version, needed}) {
    if (!v.is_string() || !v.get_ref<const std::string&>().starts_with("2.")) {
      failAt(ExitCode::unsupported, path, "asset.version",
             "glTF {} is not supported; export the file as glTF 2.0", v.dump());
    }
  }
}

std::string percentDecode(std::string_view uri) {
  const auto hex = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
    text += escape ? char(hex(uri[i + 1]) * 16 + hex(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return text;
}

uint64_t dataUriSize(const fs::path& path, const std::string& place, const std::string& uri) {
  if (!tinygltf::IsDataURI(uri)) {
    failAt(ExitCode::unsupported, path, place,
           "the data URI's type \"{}\" is not supported; export the file as .glb",
           uri.substr(0, std::min<size_t>(uri.find(','), 60)));
  }
  const std::string_view data = std::string_view(uri).substr(uri.find(',') + 1);
  size_t digits = data.size();
  while (digits > 0 && data[digits - 1] == '=') --digits;
  return uint64_t(digits) * 3 / 4;
}

// Bytes behind a URI, which is there when this returns.
uint64_t uriSize(const fs::path& path, const std::string& place, const std::string& uri) {
  if (uri.starts_with("data:")) return dataUriSize(path, place, uri);
  const fs::path file = path.parent_path() / fs::path(percentDecode(uri)).relative_path();
  std::error_code error;
  if (uri.find("://") != std::string::npos || !fs::is_regular_file(file, error)) {
    failAt(ExitCode::invalidInput, path, place,
           "there is no file \"{}\"; put it there, or export the file as .glb", file.string());
  }
  const uint64_t size = fs::file_size(file, error);
  if (error) failAt(ExitCode::io, path, place, "cannot read \"{}\": {}", file.string(), error.message());
  return size;
}

// tinygltf decodes '+' to a blank, which RFC 3986 does not.
void escapePlus(Json& uri) {
  std::string& text = uri.get_ref<std::string&>();
  if (text.starts_with("data:")) return;
  for (size_t i = text.find('+'); i != std::string::npos; i = text.find('+', i)) text.replace(i, 1, "%2B");
}

// Checks that each buffer has the bytes it declares. A source may hold more; tinygltf insists on equality, so
// its copy of the document is told the true size.
void checkBuffers(const GltfContainer& file, const fs::path& path, Json& json) {
  if (!json.contains("buffers")) return;
  for (size_t i = 0; i < json["buffers"].size(); ++i) {
    Json& buffer = json["buffers"][i];
    const std::string place = fmt::format("buffers[{}]", i);
    const bool embedded = !buffer.contains("uri");
    if (embedded && (i > 0 || file.binary.empty())) {
      failAt(ExitCode::invalidInput, path, place + ".uri",
             "missing, and there is no BIN chunk; export the file again");
    }
    const uint64_t declared = buffer["byteLength"];
    const uint64_t actual = embedded ? file.binary.size() : uriSize(path, place + ".uri", buffer["uri"]);
    if (actual < declared) {
      failAt(ExitCode::invalidInput, path, place,
             "{} bytes declared, {} there; the data is cut off, copy it again", declared, actual);
    }
    if (embedded) continue;
    buffer["byteLength"] = actual;
    escapePlus(buffer["uri"]);
  }
}

// Images of kinds that no texture reads need not be ones that tinygltf knows (KTX2 beside PNG).
void describeAsBytes(Json& uri) {
  constexpr std::string_view kBytes = "data:application/octet-stream;base64,";
  std::string& text = uri.get_ref<std::string&>();
  const size_t comma = text.find(',');
  if (text.starts_with("data:image/") && !tinygltf::IsDataURI(text) && comma < 60 &&
      text.substr(0, comma).ends_with(";base64"))
    text.replace(0, comma + 1, kBytes);
}

void checkImages(const fs::path& path, Json& json) {
  if (!json.contains("images")) return;
  for (size_t i = 0; i < json["images"].size(); ++i) {
    Json& image = json["images"][i];
    const std::string place = fmt::format("images[{}]", i);
    if (image.contains("uri") == image.contains("bufferView")) {
      failAt(ExitCode::invalidInput, path, place,
             "must have either a uri or a bufferView; export the file again");
    }
    if (!image.contains("uri")) continue;
    describeAsBytes(image["uri"]);
    if (uriSize(path, place + ".uri", image["uri"]) == 0) {
      failAt(ExitCode::invalidInput, path, place + ".uri", "the image is empty; copy it again");
    }
    escapePlus(image["uri"]);
  }
}

// Keeps the encoded bytes: only images that a surface uses are decoded (gltf_texture.cpp).
bool keepEncoded(tinygltf::Image* image, int, std::string* error, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
  if (size < 0) *error += "an image passes 2 GiB";
  if (size >= 0) image->image.assign(bytes, bytes + size);
  return size >= 0;
}

// Indices may come from a sparse accessor without a bufferView, which tinygltf refuses: its copy is given
// one, which restoreIndexViews takes away again.
void lendIndexViews(const fs::path& path, Json& json) {
  if (!json.contains("meshes")) return;
  for (const Json& mesh : json["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      if (!primitive.contains("indices")) continue;
      const size_t index = primitive["indices"];
      Json& accessor = json["accessors"][index];
      if (accessor.contains("bufferView")) continue;
      if (!accessor.contains("sparse")) {
        failAt(ExitCode::invalidInput, path, fmt::format("accessors[{}]", index),
               "indices without a bufferView; export the file again");
      }
      accessor["bufferView"] = accessor["sparse"]["values"]["bufferView"];
    }
  }
}

void restoreIndexViews(const Json& json, tinygltf::Model& model) {
  for (size_t i = 0; i < model.accessors.size(); ++i) {
    if (!json["accessors"][i].contains("bufferView")) model.accessors[i].bufferView = -1;
  }
}

// What is left for tinygltf: decoding of URIs and turning the checked document into structs. Any complaint is
// an error, since it goes on after most of them.
tinygltf::Model parseModel(const GltfContainer& file, const fs::path& path) {
  Json json = file.json;
  for (const char* unused : {"animations", "cameras", "skins", "extensions", "extras"}) json.erase(unused);
  checkBuffers(file, path, json);
  checkImages(path, json);
  lendIndexViews(path, json);
  const std::vector<unsigned char> glb = packGlb(path, json, file.binary);

  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(keepEncoded, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  bool parsed = false;
  try {
    parsed = parser.LoadBinaryFromMemory(&model, &error, &warning, glb.data(), unsigned(glb.size()),
                                         fs::absolute(path).parent_path().string());
  } catch (const std::exception& e) {
    error += e.what();
  }
  error += warning;
  std::ranges::replace(error, '\n', ' ');
  if (!parsed || !error.empty())
    failAt(ExitCode::invalidInput, path, "JSON", "{}; export the file again", error);
  restoreIndexViews(file.json, model);
  return model;
}

}  // namespace

GltfDocument readGltf(const fs::path& path) {
  GltfContainer file = readContainer(path);
  checkVersion(path, file.json);
  checkExtensions(path, file.json);
  checkDocument(path, file.json);
  checkCompression(path, file.json);
  tinygltf::Model model = parseModel(file, path);
  return {path, std::move(file.json), std::move(model)};
}

}  // namespace boxlight
