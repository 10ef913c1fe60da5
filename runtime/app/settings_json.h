// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/app/settings.h"

namespace boxlight::gpu {

/// What a settings file holds: a picture's settings and what it is of.
struct SettingsFile {
  std::filesystem::path asset, environment;  ///< empty where the file does not say
  ViewSettings settings;
};

/// Every number survives the way to JSON and back bit for bit.
nlohmann::ordered_json settingsToJson(const SettingsFile& file);

/// Takes over what `json` says and leaves the rest of `file` as it is. `name` is for messages. Error:
/// ExitCode::invalidInput naming the member that is unknown, of another kind or out of range.
void settingsFromJson(const nlohmann::json& json, const std::string& name, SettingsFile& file);

/// Paths in the file are meant from its own folder. Errors: ExitCode::io, ExitCode::invalidInput.
void readSettings(const std::filesystem::path& path, SettingsFile& file);
void writeSettings(const std::filesystem::path& path, const SettingsFile& file);

}  // namespace boxlight::gpu
