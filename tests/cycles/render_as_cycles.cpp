// SPDX-License-Identifier: Apache-2.0
// The path-traced truth with closures of Cycles in place of glTF's BSDF (cycles_closures.h).
#include <fmt/format.h>

#include "bake/scene/gltf_load.h"
#include "bake/transport/reference.h"
#include "bake/transport/reference_integrator.h"
#include "common/base/cli.h"
#include "common/light/environment.h"
#include "tests/cycles/cycles_closures.h"

using namespace boxlight;

namespace {

struct Options {
  std::string scene, environment, output, variance, model = "metal";
  float rotation = 0;
  CameraOptions camera;
  ReferenceOptions reference;
};

template <class Closures>
ReferencePicture render(const Options& options) {
  const Scene scene = loadGltf(options.scene);
  const Image image = readEnvironment(options.environment);
  const EnvironmentSampler environment(image, options.rotation);
  const Intersector world(scene);
  const ReferenceIntegrator<Closures> integrator(world, environment, kUnlimitedBounces);
  return renderPicture(
      world, environment, makeCamera(options.camera, scene.boundsMin, scene.boundsMax), options.reference,
      [&](const SurfacePoint& point, vec3 direction, const MediumStack& media, Sampler& sampler) {
        return integrator.radiance(point, direction, media, sampler);
      });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Path-trace a scene with closures of Cycles", "render_as_cycles");
  CommonOptions common;
  Options options;
  addCommonOptions(app, common);
  addCameraOptions(app, options.camera);
  app.add_option("scene", options.scene)->required();
  app.add_option("--env", options.environment)->required();
  app.add_option("--env-rotation", options.rotation);
  app.add_option("-o", options.output)->required();
  app.add_option("--variance", options.variance);
  app.add_option("--spp", options.reference.samplesPerPixel);
  app.add_option("--seed", options.reference.seed);
  app.add_option("--model", options.model)->check(CLI::IsMember({"metal", "glass"}));
  addOnOff(app, "--background", options.reference.background, "on or off");
  return runMain(app, argc, argv, common, [&] {
    const ReferencePicture picture =
        options.model == "glass" ? render<cycles::Glass>(options) : render<cycles::Metal>(options);
    writeImage(options.output, picture.mean);
    if (!options.variance.empty()) writeImage(options.variance, picture.variance);
  });
}
