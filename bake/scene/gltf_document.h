// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace boxlight {

/// A glTF file that has been opened and checked. Every index in `model` lies inside its array and every
/// bufferView inside its buffer; buffers are in memory and each image holds its encoded bytes. Accessors are
/// checked by AccessorReader.
struct GltfDocument {
  std::filesystem::path path;
  nlohmann::json json;    ///< the document as it stands in the file
  tinygltf::Model model;  ///< without cameras, skins and animations
};

/// Errors: io if the file itself cannot be read; invalidInput if it is damaged or a buffer or an image is
/// missing; unsupported for another version of glTF, for extensionsRequired that are not supported and for
/// data that exists only compressed. Extensions that are used but not supported are named in one warning.
GltfDocument readGltf(const std::filesystem::path& path);

}  // namespace boxlight
