// SPDX-License-Identifier: Apache-2.0
//
// boxlight_data: every scene and environment of the project, made by code. The same build makes the same
// bytes.
#include <charconv>

#include "common/base/cli.h"
#include "common/base/error.h"
#include "data/environments.h"
#include "data/scenes.h"

namespace {

using namespace boxlight;

data::Parameters parseParameters(const std::vector<std::string>& settings) {
  data::Parameters parameters;
  for (const std::string& setting : settings) {
    const size_t equals = setting.find('=');
    const char *first = setting.data() + equals + 1, *last = setting.data() + setting.size();
    double value = 0;
    if (equals == std::string::npos || std::from_chars(first, last, value).ptr != last || first == last)
      fail(ExitCode::usage, "--set {}: expected NAME=NUMBER", setting);
    parameters[setting.substr(0, equals)] = value;
  }
  return parameters;
}

void writeDemo(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail(ExitCode::io, "{}: {}", folder.string(), error.message());
  data::writeGlb(folder / "teapot.glb", data::makeScene("teapot"));
  for (const char* name : {"sky", "studio"})
    writeImage(folder / (std::string(name) + ".exr"), data::makeEnvironment(name));
}

void list() {
  for (const data::SceneRecipe& recipe : data::sceneRecipes()) {
    fmt::print("scene {}: {}", recipe.name, recipe.about);
    for (const auto& [name, value] : recipe.defaults) fmt::print("; {}={}", name, value);
    fmt::print("\n");
  }
  for (const data::EnvironmentRecipe& recipe : data::environmentRecipes())
    fmt::print("environment {}: {}\n", recipe.name, recipe.about);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Makes the project's own scenes and environments", "boxlight_data"};
  app.require_subcommand(1);
  CommonOptions options;
  std::string name;
  std::filesystem::path output;
  std::vector<std::string> settings;

  CLI::App* demo = app.add_subcommand("demo", "Writes teapot.glb, sky.exr and studio.exr");
  demo->add_option("FOLDER", output)->required();
  CLI::App* scene = app.add_subcommand("scene", "Writes one scene");
  scene->add_option("NAME", name)->required();
  scene->add_option("OUT.glb", output)->required();
  scene->add_option("--set", settings, "Changes a parameter of the scene")->option_text("NAME=NUMBER");
  CLI::App* environment = app.add_subcommand("environment", "Writes one environment");
  environment->add_option("NAME", name)->required();
  environment->add_option("OUT.exr", output)->required();
  CLI::App* listing = app.add_subcommand("list", "Prints what there is");

  return runMain(app, argc, argv, options, [&] {
    if (*demo) writeDemo(output);
    if (*scene) data::writeGlb(output, data::makeScene(name, parseParameters(settings)));
    if (*environment) writeImage(output, data::makeEnvironment(name));
    if (*listing) list();
  });
}
