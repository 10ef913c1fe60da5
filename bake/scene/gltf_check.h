// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace boxlight {

/// Holds a glTF document to the parts of the schema that loadGltf relies on: types, ranges of enumerations,
/// lengths of number arrays, presence of what is required, and every index inside the array that it points
/// into. tinygltf takes most of these mistakes in silence. After it, every bufferView also lies inside the
/// declared length of its buffer. Errors: invalidInput, naming the place.
void checkDocument(const std::filesystem::path& path, const nlohmann::json& document);

}  // namespace boxlight
