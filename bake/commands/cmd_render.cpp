// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_render.h"

#include <tbb/global_control.h>

#include <memory>

#include "bake/commands/transport_options.h"
#include "bake/scene/gltf_load.h"
#include "bake/transport/reference.h"
#include "common/base/file.h"
#include "common/base/log.h"
#include "common/image/camera.h"
#include "common/light/environment.h"

namespace boxlight {
namespace {

struct RenderOptions {
  std::string scene, environment, output, variance;
  float rotation = 0.0f, intensity = 1.0f, exposure = 0.0f;
  EnvironmentTilt tilt;
  CameraOptions camera;
  ReferenceOptions reference;
  TransportOptions transport;
};

void writePicture(const std::filesystem::path& path, const Image& image, float exposure) {
  writeImage(path, path.extension() == ".png" ? toDisplay(image, exposure) : image);
}

void render(RenderOptions options, const CommonOptions& common) {
  checkImageExtension(options.output);
  checkOutput(options.output, {options.scene, options.environment, options.variance});
  if (!options.variance.empty()) checkOutput(options.variance, {options.scene, options.environment});
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    resolveThreads(common.threads));
  Scene scene = loadGltf(options.scene);
  options.transport.applyTo(scene);
  Image environment = readEnvironment(options.environment);
  for (float& value : environment.pixels) value *= options.intensity;
  const Camera camera = makeCamera(options.camera, scene.boundsMin, scene.boundsMax);
  const Intersector world(scene);
  options.reference.progress = common.quiet ? ProgressStyle::none : common.progress;
  options.reference.bounces = options.transport.bounceLimit();
  options.reference.radianceLimit = options.transport.energyLimit();
  options.reference.seed = options.transport.seed;
  log().info("{}: {} triangles, {}x{} pixels, {} paths a pixel", options.scene, scene.triangles.size(),
             camera.size.x, camera.size.y, options.reference.samplesPerPixel);
  const ReferencePicture picture = renderReference(
      world, EnvironmentSampler(environment, options.rotation, options.tilt), camera, options.reference);
  options.transport.reportRemoved(picture.removed);
  writePicture(options.output, picture.mean, options.exposure);
  if (!options.variance.empty()) writeImage(options.variance, picture.variance);
}

}  // namespace

void addRenderCommand(CLI::App& app, CommonOptions& common) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Path-trace the truth of a picture");
  addCommonOptions(*command, common);
  command->add_option("scene", options->scene, "glTF 2.0 scene, .glb or .gltf")
      ->required()
      ->option_text("SCENE");
  command->add_option("--env", options->environment, "Environment image, equirectangular")
      ->required()
      ->option_text("IMAGE");
  command->add_option("-o,--output", options->output, "Picture: .exr (linear) or .png (tone-mapped)")
      ->required()
      ->option_text("FILE");
  command->add_option("--variance", options->variance, "Also write the variance of every pixel's mean, .exr")
      ->check([](const std::string& file) {
        return std::filesystem::path(file).extension() == ".exr" ? "" : "must end in .exr";
      })
      ->option_text("FILE");
  addCameraOptions(*command, options->camera);
  command->add_option("--spp", options->reference.samplesPerPixel, "Paths per pixel")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();
  addTransportOptions(*command, options->transport,
                      "Largest radiance of a path; more is removed and reported. 0 = no limit");
  addTurnOptions(*command, options->rotation, options->tilt);
  command
      ->add_option("--env-intensity", options->intensity, "Radiance of the environment times X (default: 1)")
      ->check(inRange(0, 1e6))
      ->option_text("X");
  command->add_option("--exposure", options->exposure, "Stops, of a PNG")
      ->check(inRange(-100, 100))
      ->option_text("EV");
  addOnOff(*command, "--background", options->reference.background,
           "Draw the environment behind the object: on or off");
  command->callback([options, &common] { render(*options, common); });
}

}  // namespace boxlight
