// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace boxlight {

/// The two parts of a glTF file: its document and, in a .glb, the BIN chunk (glTF 2.0, chapter 4).
struct GltfContainer {
  nlohmann::json json;            ///< an object; nested at most 256 deep
  std::vector<std::byte> binary;  ///< empty if there is none
};

/// Reads .gltf and .glb, told apart by their content. Errors: io if the file cannot be read, invalidInput if
/// it is damaged, unsupported for another version of the container.
GltfContainer readContainer(const std::filesystem::path& path);

/// The bytes of a .glb with these parts; for tinygltf, which reads nothing else from memory with a BIN chunk.
/// Error: unsupported past 2 GiB.
std::vector<unsigned char> packGlb(const std::filesystem::path& path, const nlohmann::json& json,
                                   std::span<const std::byte> binary);

}  // namespace boxlight
