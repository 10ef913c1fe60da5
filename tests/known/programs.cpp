// SPDX-License-Identifier: Apache-2.0
#include "tests/known/programs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>

namespace boxlight::test {
namespace {

/// Removed when the process ends.
struct Folder {
  Folder() : path(std::filesystem::temp_directory_path() / fmt::format("boxlight-known-{}", ::getpid())) {
    std::filesystem::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

/// The file that `make` writes for `key`, made at the first call.
std::string once(const std::string& key, const char* extension,
                 const std::function<void(const std::string&)>& make) {
  static std::map<std::string, std::string> files;
  const auto [entry, isNew] = files.try_emplace(key);
  if (isNew) {
    entry->second = file(fmt::format("{}{}", files.size(), extension));
    make(entry->second);
  }
  return entry->second;
}

}  // namespace

std::string file(const std::string& name) {
  static const Folder folder;
  return (folder.path / name).string();
}

void run(const std::string& program, const std::string& arguments) {
  const std::string command = fmt::format("{}/{} {}", BOXLIGHT_BIN, program, arguments);
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

double tolerance(Way way) { return way == Way::truth ? 0.005 : 0.015; }
const char* name(Way way) { return way == Way::truth ? "ptbake render" : "ptbake bake + ptview"; }

Image picture(Way way, const Shot& shot) {
  const size_t space = shot.scene.find(' ');
  const std::string scene = once("scene " + shot.scene, ".glb", [&](const std::string& made) {
    run("boxlight_data", fmt::format("scene {} {} {}", shot.scene.substr(0, space), made,
                                     space == std::string::npos ? "" : shot.scene.substr(space)));
  });
  const std::string environment =
      once("environment " + shot.environment, ".exr", [&](const std::string& made) {
        run("boxlight_data", fmt::format("environment {} {}", shot.environment, made));
      });
  const std::string camera = shot.camera + " --background off";
  const std::string output = once(
      fmt::format("{} {} {} {}", name(way), shot.scene, shot.environment, camera), ".exr",
      [&](const std::string& made) {
        if (way == Way::truth)
          return run("ptbake", fmt::format("render {} --env {} -o {} {} {} -q", scene, environment, made,
                                           camera, shot.renderOptions));
        const std::string asset =
            once("asset " + shot.scene + shot.bakeOptions, ".ptb", [&](const std::string& ptb) {
              run("ptbake", fmt::format("bake {} -o {} {} -q", scene, ptb, shot.bakeOptions));
            });
        run("ptview",
            fmt::format("{} --headless --env {} -o {} {} --validation", asset, environment, made, camera));
      });
  return readImage(output);
}

Rgb objectMean(const Image& image) {
  dvec3 sum(0);
  double coverage = 0;
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      sum += dvec3(rgbAt(image, x, y));
      coverage += double(alphaAt(image, x, y));
    }
  if (coverage == 0) throw std::runtime_error("the picture is empty");
  return Rgb(sum / coverage);
}

Rgb objectAt(const Image& image, uint32_t x, uint32_t y) { return rgbAt(image, x, y) / alphaAt(image, x, y); }

}  // namespace boxlight::test
