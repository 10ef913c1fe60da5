// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/view_options.h"

#include <map>

#include "common/base/error.h"
#include "common/image/image.h"
#include "common/image/image_sequence.h"
#include "runtime/app/settings_json.h"

namespace boxlight::gpu {
namespace {

void addPictureOptions(CLI::App& app, ViewOptions& options) {
  static const std::map<std::string, bool> switches = {{"on", true}, {"off", false}};
  app.add_flag("--headless", options.headless,
               "Render one picture to a file; without it, ptview opens a window");
  app.add_option("--env", options.environment,
                 "Environment: an equirectangular HDR image, or, headless, a numbered sequence of them, "
                 "sky.####.exr or sky.%04d.exr, for --frames N pictures whose names are numbered alike")
      ->option_text("IMAGE");
  app.add_option("-o,--output", options.output, "The picture: .exr (linear) or .png (sRGB)")
      ->option_text("FILE");
  addTurnOptions(app, options.settings.environmentDegrees, options.settings.environmentTilt);
  app.add_option("--env-intensity", options.settings.environmentIntensity,
                 "Radiance of the environment times X (default: 1)")
      ->check(inRange(0, 1e6))
      ->option_text("X");
  app.add_option("--exposure", options.settings.exposure, "Of a PNG and of the window: radiance times 2^EV")
      ->check(inRange(-100, 100))
      ->option_text("EV");
  static const std::map<std::string, ToneMap> toneMaps = {{kToneMapNames[0], ToneMap::none},
                                                          {kToneMapNames[1], ToneMap::reinhard},
                                                          {kToneMapNames[2], ToneMap::aces},
                                                          {kToneMapNames[3], ToneMap::neutral}};
  app.add_option("--tone-map", options.settings.toneMap,
                 "Of a PNG and of the window, after exposure (default: none)")
      ->transform(CLI::CheckedTransformer(toneMaps))
      ->option_text("none|reinhard|aces|neutral");
  app.add_option("--background", options.settings.background,
                 "on: show the environment behind the object; off: transparent")
      ->transform(CLI::CheckedTransformer(switches))
      ->option_text("on|off");
}

/// Read at once, wherever it stands, while the other options are set at the end: they come out on top.
void addSettingsOption(CLI::App& app, ViewOptions& options) {
  const auto read = [&options](const std::string& path) {
    SettingsFile file{{}, {}, options.settings};
    readSettings(path, file);
    options.asset = file.asset;
    options.environment = file.environment;
    options.settings = file.settings;
  };
  app.add_option_function<std::string>(
         "--settings", read,
         "Asset, light, camera and all else that the window saved; other options change what they name")
      ->trigger_on_parse()
      ->option_text("FILE.json");
}

void addWindowOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("--truth", options.truth, "A picture of the first camera for the window's split screen (T)")
      ->option_text("IMAGE");
  app.add_option("--truth-scene", options.truthScene,
                 "The glTF scene of the asset: T has ptbake render the truth of any camera from it")
      ->option_text("SCENE");
  app.add_option("--captures", options.captures,
                 "Folder for the window's screenshots, settings and recordings (default: the current one)")
      ->option_text("FOLDER");
  app.add_flag("--list-keys", options.listKeys, "Print the window's keys as a table and end");
}

void addQualityOptions(CLI::App& app, ViewOptions& options) {
  static const std::map<std::string, Interpolation> interpolations = {{"energy", Interpolation::energy},
                                                                      {"weight", Interpolation::weight}};
  app.add_option("--boxes", options.settings.boxes,
                 "Evaluate the first K boxes of each kernel, the strongest; the energy of the others is left "
                 "out (default: all)")
      ->check(CLI::Range(1, 65535))
      ->option_text("K");
  app.add_option(
         "--interpolation", options.settings.interpolation,
         "Between the views: energy (exact under constant light) or weight (the sketch, read literally)")
      ->transform(CLI::CheckedTransformer(interpolations))
      ->option_text("energy|weight");
  addSize(app, "--sat-size", options.settings.lightSize,
          "Size of the summed-area table of the light (default: by the sizes of the asset's boxes, from "
          "512x256 to 2048x1024)");
  static const std::map<std::string, SatScheme> schemes = {{"compact", SatScheme::compact},
                                                           {"exact", SatScheme::exact}};
  app.add_option("--sat", options.settings.satScheme,
                 "Prefixes of the table: compact (42 bits, 16 bytes) or exact (64 bits, 24 bytes)")
      ->transform(CLI::CheckedTransformer(schemes))
      ->option_text("compact|exact");
  app.add_option("--samples", options.settings.samples, "N x N visibility samples a pixel (default: 2)")
      ->check(CLI::Range(1, 8))
      ->option_text("N");
  app.add_option("--layers", options.settings.layers,
                 "Show the nearest N layers of blended surfaces in each sample (default: 8)")
      ->check(CLI::Range(1, 64))
      ->option_text("N");
}

void addDeviceOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("--device", options.device,
                 "Vulkan device: its index or part of its name (default: the fastest kind)")
      ->option_text("NAME|INDEX");
  app.add_flag("--list-devices", options.listDevices, "Print the Vulkan devices and end");
  app.add_option("--frames", options.frames,
                 "Draw N frames, for the times of --stats or of a numbered environment; in the window, "
                 "frames of a recording")
      ->check(CLI::Range(1, 100000))
      ->option_text("N");
  app.add_option("--first-frame", options.firstFrame, "Number of a sequence's first frame (default: 1)")
      ->check(CLI::Range(0, 10000000))
      ->option_text("N");
  app.add_option("--stats", options.stats, "Write times and counts as JSON")->option_text("FILE.json");
  app.add_flag("--validation", options.validation,
               "Load the Vulkan validation layer; any message of it is a failure");
}

}  // namespace

void addViewOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("ASSET", options.asset, "The baked asset, .ptb");
  addPictureOptions(app, options);
  addCameraOptions(app, options.settings.camera);
  addQualityOptions(app, options);
  addSettingsOption(app, options);
  addWindowOptions(app, options);
  addDeviceOptions(app, options);
  addCommonOptions(app, options.common);
}

void checkViewOptions(const ViewOptions& options) {
  if (options.listDevices || options.listKeys) return;
  if (options.asset.empty())
    fail(ExitCode::usage,
         "name an asset: ptview ASSET [--env IMAGE], or ptview ASSET --headless --env IMAGE -o FILE");
  if (!options.headless) {
    if (!options.output.empty() || !options.stats.empty())
      fail(ExitCode::usage,
           "-o and --stats belong to --headless; the window's captures go to --captures FOLDER");
    return;
  }
  if (options.environment.empty()) fail(ExitCode::usage, "--headless needs --env IMAGE");
  if (options.output.empty()) fail(ExitCode::usage, "--headless needs -o FILE.exr or FILE.png");
  checkImageExtension(options.output);
  if (isNumbered(options.environment) && options.frames > 1 && !isNumbered(options.output))
    fail(ExitCode::usage,
         "--env names a sequence: number the pictures, too, for example -o picture.####.exr; '{}' would be "
         "written {} times",
         options.output.string(), options.frames);
}

}  // namespace boxlight::gpu
