// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "common/base/error.h"
#include "runtime/app/settings_json.h"
#include "tests/support/temporary_path.h"

namespace boxlight::gpu {
namespace {

SettingsFile unusual() {
  SettingsFile file{"/a/b.ptb", "/c d.exr", {}};
  file.settings.camera.eye = vec3(0.1f, -1e-7f, 3e30f);
  file.settings.camera.target = vec3(1 / 3.0f, 2, 3);
  file.settings.camera.up = {0, 0.6f, 0.8f};
  file.settings.camera.fovDegrees = 33.3f;
  file.settings.camera.size = {123, 457};
  file.settings.environmentDegrees = -77.7f;
  file.settings.exposure = 1.1f;
  file.settings.toneMap = ToneMap::neutral;
  file.settings.background = false;
  file.settings.samples = 3;
  file.settings.boxes = 5;
  file.settings.layers = 2;
  file.settings.interpolation = Interpolation::weight;
  file.settings.lightSize = {100, 50};
  return file;
}

TEST(Settings, SurviveTheWayThroughAFileBitForBit) {
  const auto path = test::temporaryPath("settings.json");
  writeSettings(path, unusual());
  SettingsFile file;
  readSettings(path, file);
  std::filesystem::remove(path);
  EXPECT_EQ(settingsToJson(file), settingsToJson(unusual()));
  EXPECT_EQ(file.settings.camera, unusual().settings.camera);
  EXPECT_EQ(file.settings.environmentDegrees, unusual().settings.environmentDegrees);
  EXPECT_EQ(file.settings.interpolation, Interpolation::weight);
  EXPECT_EQ(file.settings.toneMap, ToneMap::neutral);
}

TEST(Settings, WhatAFileDoesNotSayStays) {
  SettingsFile file = unusual();
  settingsFromJson(nlohmann::json::parse(R"({"exposure": 2, "camera": {"fov": 50}})"), "x", file);
  SettingsFile expected = unusual();
  expected.settings.exposure = 2;
  expected.settings.camera.fovDegrees = 50;
  EXPECT_EQ(settingsToJson(file), settingsToJson(expected));
}

TEST(Settings, APathIsMeantFromTheFilesFolder) {
  const auto path = test::temporaryPath("relative.json");
  std::ofstream(path) << R"({"asset": "x/y.ptb", "environment": "/z.exr"})";
  SettingsFile file;
  readSettings(path, file);
  std::filesystem::remove(path);
  EXPECT_EQ(file.asset, path.parent_path() / "x/y.ptb");
  EXPECT_EQ(file.environment, "/z.exr");
}

TEST(Settings, WhatIsWrongIsNamed) {
  const std::pair<const char*, const char*> cases[] = {{R"({"exposre": 1})", "exposre"},
                                                       {R"({"exposure": "1"})", "exposure"},
                                                       {R"({"exposure": 1e9})", "exposure"},
                                                       {R"({"exposure": null})", "exposure"},
                                                       {R"({"camera": {"eye": [1, 2]}})", "camera.eye"},
                                                       {R"({"camera": {"eye": [1, 2, "3"]}})", "camera.eye"},
                                                       {R"({"camera": {"size": [0, 2]}})", "camera.size"},
                                                       {R"({"camera": {"size": [1.5, 2]}})", "camera.size"},
                                                       {R"({"camera": 3})", "camera"},
                                                       {R"({"tone_map": "filmic"})", "neutral"},
                                                       {R"({"background": 1})", "background"},
                                                       {R"({"samples": 9})", "samples"},
                                                       {R"({"boxes": -1})", "boxes"},
                                                       {R"({"asset": 1})", "asset"},
                                                       {R"([1])", "object"}};
  for (const auto& [text, named] : cases) {
    SettingsFile file;
    try {
      settingsFromJson(nlohmann::json::parse(text), "file.json", file);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalidInput);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("file.json"), std::string::npos) << error.what();
    }
  }
}

TEST(Settings, ADamagedFileChangesNothing) {
  const auto path = test::temporaryPath("damaged.json");
  SettingsFile file = unusual();
  for (const char* text : {"", "{", "{\"exposure\": 1,}", "{\"exposure\": 1, \"boxes\": 1e9}", "\xff\xfe"}) {
    std::ofstream(path) << text;
    EXPECT_THROW(readSettings(path, file), Error) << text;
    EXPECT_EQ(settingsToJson(file), settingsToJson(unusual()));
  }
  std::filesystem::remove(path);
  EXPECT_THROW(readSettings(path, file), Error);
}

}  // namespace
}  // namespace boxlight::gpu
