// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/settings_json.h"

#include <cmath>
#include <functional>
#include <map>

#include "common/base/error.h"
#include "common/base/file.h"

namespace boxlight::gpu {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

constexpr std::array kInterpolationNames = {"energy", "weight"};
constexpr std::array kSatNames = {"compact", "exact"};
constexpr double kLargest = 3e38;

/// One member of the file, for messages.
struct Member {
  const std::string& file;
  const std::string& name;
  const Json& value;

  [[noreturn]] void refuse(const std::string& expected) const {
    fail(ExitCode::invalidInput, "{}: {}: expected {}, got {}", file, name, expected, value.dump());
  }
  double number(double low, double high) const {
    const double x = value.is_number() ? value.get<double>() : NAN;
    if (!(x >= low && x <= high)) refuse(fmt::format("a number from {} to {}", low, high));
    return x;
  }
  uint32_t whole(uint32_t low, uint32_t high) const {
    const double x = number(low, high);
    if (x != std::floor(x)) refuse("a whole number");
    return uint32_t(x);
  }
  template <size_t N>
  uint32_t oneOf(const std::array<const char*, N>& names) const {
    for (uint32_t i = 0; i < N; ++i)
      if (value == names[i]) return i;
    refuse(fmt::format("one of {}", fmt::join(names, ", ")));
  }
  bool flag() const {
    if (!value.is_boolean()) refuse("true or false");
    return value.get<bool>();
  }
  std::string text() const {
    if (!value.is_string()) refuse("a text");
    return value.get<std::string>();
  }
  const Json& list(size_t size) const {
    if (!value.is_array() || value.size() != size) refuse(fmt::format("{} numbers", size));
    return value;
  }
  vec3 vector() const {
    vec3 v;
    for (int i = 0; i < 3; ++i)
      v[i] = float(Member{file, name, list(3)[size_t(i)]}.number(-kLargest, kLargest));
    return v;
  }
  uvec2 size() const {
    uvec2 v;
    for (int i = 0; i < 2; ++i) v[i] = Member{file, name, list(2)[size_t(i)]}.whole(1, 16384);
    return v;
  }
};

using Setter = std::function<void(const Member&)>;

void takeMembers(const Json& object, const std::string& file, const std::string& place,
                 const std::map<std::string, Setter>& setters) {
  if (!object.is_object()) fail(ExitCode::invalidInput, "{}: {}expected a JSON object", file, place);
  for (const auto& [key, value] : object.items()) {
    const std::string name = place + key;
    const auto setter = setters.find(key);
    if (setter == setters.end())
      fail(ExitCode::invalidInput, "{}: {} is no setting; docs/ptview.md lists them", file, name);
    setter->second({file, name, value});
  }
}

void cameraFromJson(const Member& member, CameraOptions& camera) {
  takeMembers(member.value, member.file, member.name + ".",
              {{"eye", [&](const Member& m) { camera.eye = m.vector(); }},
               {"target", [&](const Member& m) { camera.target = m.vector(); }},
               {"up", [&](const Member& m) { camera.up = m.vector(); }},
               {"fov", [&](const Member& m) { camera.fovDegrees = float(m.number(0.1, 170)); }},
               {"size", [&](const Member& m) { camera.size = m.size(); }}});
}

Ordered listOf(vec3 v) { return {v.x, v.y, v.z}; }
Ordered listOf(uvec2 v) { return {v.x, v.y}; }

Ordered cameraToJson(const CameraOptions& camera) {
  Ordered json = Ordered::object();
  if (camera.eye) json["eye"] = listOf(*camera.eye);
  if (camera.target) json["target"] = listOf(*camera.target);
  json["up"] = listOf(camera.up);
  json["fov"] = camera.fovDegrees;
  json["size"] = listOf(camera.size);
  return json;
}

}  // namespace

Ordered settingsToJson(const SettingsFile& file) {
  const ViewSettings& s = file.settings;
  Ordered json = Ordered::object();
  if (!file.asset.empty()) json["asset"] = file.asset.string();
  if (!file.environment.empty()) json["environment"] = file.environment.string();
  json["camera"] = cameraToJson(s.camera);
  json["env_rotation"] = s.environmentDegrees;
  json["env_pitch"] = s.environmentTilt.pitch;
  json["env_roll"] = s.environmentTilt.roll;
  json["env_intensity"] = s.environmentIntensity;
  json["exposure"] = s.exposure;
  json["tone_map"] = kToneMapNames[size_t(s.toneMap)];
  json["background"] = s.background;
  json["samples"] = s.samples;
  json["boxes"] = s.boxes;
  json["layers"] = s.layers;
  json["interpolation"] = kInterpolationNames[size_t(s.interpolation)];
  if (s.lightSize) json["sat_size"] = listOf(*s.lightSize);
  json["sat"] = kSatNames[size_t(s.satScheme)];
  return json;
}

void settingsFromJson(const Json& json, const std::string& name, SettingsFile& file) {
  ViewSettings& s = file.settings;
  takeMembers(json, name, "",
              {{"asset", [&](const Member& m) { file.asset = m.text(); }},
               {"environment", [&](const Member& m) { file.environment = m.text(); }},
               {"camera", [&](const Member& m) { cameraFromJson(m, s.camera); }},
               {"env_rotation", [&](const Member& m) { s.environmentDegrees = float(m.number(-1e6, 1e6)); }},
               {"env_pitch", [&](const Member& m) { s.environmentTilt.pitch = float(m.number(-1e6, 1e6)); }},
               {"env_roll", [&](const Member& m) { s.environmentTilt.roll = float(m.number(-1e6, 1e6)); }},
               {"env_intensity", [&](const Member& m) { s.environmentIntensity = float(m.number(0, 1e6)); }},
               {"exposure", [&](const Member& m) { s.exposure = float(m.number(-100, 100)); }},
               {"tone_map", [&](const Member& m) { s.toneMap = ToneMap(m.oneOf(kToneMapNames)); }},
               {"background", [&](const Member& m) { s.background = m.flag(); }},
               {"samples", [&](const Member& m) { s.samples = m.whole(1, 8); }},
               {"boxes", [&](const Member& m) { s.boxes = m.whole(0, 65535); }},
               {"layers", [&](const Member& m) { s.layers = m.whole(1, 64); }},
               {"interpolation",
                [&](const Member& m) { s.interpolation = Interpolation(m.oneOf(kInterpolationNames)); }},
               {"sat_size", [&](const Member& m) { s.lightSize = m.size(); }},
               {"sat", [&](const Member& m) { s.satScheme = SatScheme(m.oneOf(kSatNames)); }}});
}

void readSettings(const std::filesystem::path& path, SettingsFile& file) {
  const std::vector<std::byte> bytes = readFile(path);
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  Json json;
  try {
    json = Json::parse(first, first + bytes.size());
  } catch (const Json::exception& error) {
    fail(ExitCode::invalidInput, "{}: not a settings file: {}", path.string(), error.what());
  }
  SettingsFile read = file;
  read.asset.clear();
  read.environment.clear();
  settingsFromJson(json, path.string(), read);
  if (!read.asset.empty()) file.asset = path.parent_path() / read.asset;
  if (!read.environment.empty()) file.environment = path.parent_path() / read.environment;
  file.settings = read.settings;
}

void writeSettings(const std::filesystem::path& path, const SettingsFile& file) {
  SettingsFile absolute = file;
  if (!file.asset.empty()) absolute.asset = std::filesystem::absolute(file.asset);
  if (!file.environment.empty()) absolute.environment = std::filesystem::absolute(file.environment);
  writeTextFile(path, settingsToJson(absolute).dump(2) + "\n");
}

}  // namespace boxlight::gpu
