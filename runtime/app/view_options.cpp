// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/view_options.h"

#include <map>

#include "common/base/error.h"
#include "common/image/image.h"

namespace boxlight::gpu {
namespace {

void addPictureOptions(CLI::App& app, ViewOptions& options) {
  static const std::map<std::string, bool> switches = {{"on", true}, {"off", false}};
  app.add_flag("--headless", options.headless, "Render one picture to a file, without a window");
  app.add_option("--env", options.environment, "Environment: an equirectangular HDR image")
      ->option_text("IMAGE");
  app.add_option("-o,--output", options.output, "The picture: .exr (linear) or .png (sRGB)")
      ->option_text("FILE");
  app.add_option("--env-rotation", options.environmentDegrees,
                 "Turn the environment about +Y, in degrees counter-clockwise seen from above")
      ->check(inRange(-1e6, 1e6))
      ->option_text("DEG");
  app.add_option("--exposure", options.exposure, "Of a PNG: radiance times 2^EV")
      ->check(inRange(-100, 100))
      ->option_text("EV");
  app.add_option("--background", options.background,
                 "on: show the environment behind the object; off: transparent")
      ->transform(CLI::CheckedTransformer(switches))
      ->option_text("on|off");
}

void addQualityOptions(CLI::App& app, ViewOptions& options) {
  static const std::map<std::string, Interpolation> interpolations = {{"energy", Interpolation::energy},
                                                                      {"weight", Interpolation::weight}};
  app.add_option("--boxes", options.boxes,
                 "Evaluate the first K boxes of each kernel, the strongest; the energy of the others is left "
                 "out (default: all)")
      ->check(CLI::Range(1, 65535))
      ->option_text("K");
  app.add_option(
         "--interpolation", options.interpolation,
         "Between the views: energy (exact under constant light) or weight (the sketch, read literally)")
      ->transform(CLI::CheckedTransformer(interpolations))
      ->option_text("energy|weight");
  addSize(app, "--sat-size", options.lightSize,
          "Size of the summed-area table of the light (default: 512x256)");
  app.add_option("--samples", options.samples, "N x N visibility samples a pixel (default: 2)")
      ->check(CLI::Range(1, 8))
      ->option_text("N");
  app.add_option("--layers", options.layers,
                 "Show the nearest N layers of blended surfaces in each sample (default: 8)")
      ->check(CLI::Range(1, 64))
      ->option_text("N");
}

void addDeviceOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("--device", options.device,
                 "Vulkan device: its index or part of its name (default: the fastest kind)")
      ->option_text("NAME|INDEX");
  app.add_flag("--list-devices", options.listDevices, "Print the Vulkan devices and end");
  app.add_option("--frames", options.frames, "Draw the frame N times, for the times of --stats")
      ->check(CLI::Range(1, 100000))
      ->option_text("N");
  app.add_option("--stats", options.stats, "Write times and counts as JSON")->option_text("FILE.json");
  app.add_flag("--validation", options.validation,
               "Load the Vulkan validation layer; any message of it is a failure");
}

}  // namespace

void addViewOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("ASSET", options.asset, "The baked asset, .ptb");
  addPictureOptions(app, options);
  addCameraOptions(app, options.camera);
  addQualityOptions(app, options);
  addDeviceOptions(app, options);
  addCommonOptions(app, options.common);
}

void checkViewOptions(const ViewOptions& options) {
  if (options.listDevices) return;
  if (options.asset.empty())
    fail(ExitCode::usage, "name an asset: ptview ASSET --headless --env IMAGE -o FILE");
  if (!options.headless)
    fail(ExitCode::usage,
         "there is no window: add --headless, and name the light and the picture (--env IMAGE -o FILE)");
  if (options.environment.empty()) fail(ExitCode::usage, "--headless needs --env IMAGE");
  if (options.output.empty()) fail(ExitCode::usage, "--headless needs -o FILE.exr or FILE.png");
  checkImageExtension(options.output);
}

}  // namespace boxlight::gpu
