// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace boxlight {

bool isSupportedExtension(std::string_view name);

/// The end of a message about content that exists only by way of this extension: what turns the file into one
/// without it, as a command where there is one.
const char* conversionOf(std::string_view extension);

/// Fails with unsupported for extensionsRequired that are not supported, and names others in extensionsUsed
/// in one warning.
void checkExtensions(const std::filesystem::path& path, const nlohmann::json& document);

/// Fails with unsupported if attributes or buffers exist only compressed, whatever extensionsRequired says.
/// The document has passed checkDocument.
void checkCompression(const std::filesystem::path& path, const nlohmann::json& document);

}  // namespace boxlight
