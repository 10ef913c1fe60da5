// SPDX-License-Identifier: Apache-2.0
// The path-traced truth with the metal of Cycles' Glossy BSDF: GGX with separable Smith masking and no
// Fresnel term. With it, transport can be compared against Cycles without a difference of models
// (docs/theory.md, section 9).
#include <fmt/format.h>

#include <cmath>

#include "bake/scene/gltf_load.h"
#include "bake/transport/reference.h"
#include "bake/transport/reference_integrator.h"
#include "common/base/cli.h"
#include "common/light/environment.h"
#include "common/light/ggx.h"

using namespace boxlight;

namespace {

class SeparableMetal {
 public:
  SeparableMetal(const MaterialSample& m, vec3 wo, const Interface&, vec3)
      : wo_(wo), colour_(m.baseColor), alpha_(ggx::alphaOf(m.roughness)) {}

  Rgb emission() const { return Rgb(0.0f); }
  LobeValue evaluate(vec3 wi) const {
    if (wo_.z <= 0.0f || wi.z <= 0.0f) return {};
    const vec3 half = glm::normalize(wo_ + wi);
    const float microfacets =
        ggx::distribution(half, alpha_) * ggx::masking(wo_.z, alpha_) * ggx::masking(wi.z, alpha_);
    return {colour_ * (microfacets / (4.0f * wo_.z)),
            ggx::visibleNormalDensity(wo_, half, alpha_) / (4.0f * glm::dot(wo_, half))};
  }
  LobeSample sample(float, vec2 random) const {
    return {glm::reflect(-wo_, ggx::sampleVisibleNormal(wo_, alpha_, random))};
  }

 private:
  vec3 wo_;
  Rgb colour_;
  float alpha_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Path-trace a scene with Cycles' metal", "separable_metal");
  CommonOptions common;
  CameraOptions cameraOptions;
  ReferenceOptions options;
  std::string scenePath, environmentPath, output, variance;
  addCommonOptions(app, common);
  addCameraOptions(app, cameraOptions);
  app.add_option("scene", scenePath)->required();
  app.add_option("--env", environmentPath)->required();
  app.add_option("-o", output)->required();
  app.add_option("--variance", variance);
  app.add_option("--spp", options.samplesPerPixel);
  return runMain(app, argc, argv, common, [&] {
    const Scene scene = loadGltf(scenePath);
    const Image image = readEnvironment(environmentPath);
    const EnvironmentSampler environment(image, 0);
    const Intersector world(scene);
    const ReferenceIntegrator<SeparableMetal> integrator(world, environment, kUnlimitedBounces);
    options.background = false;
    const ReferencePicture picture = renderPicture(
        world, environment, makeCamera(cameraOptions, scene.boundsMin, scene.boundsMax), options,
        [&](const SurfacePoint& point, vec3 direction, const MediumStack& media, Sampler& sampler) {
          return integrator.radiance(point, direction, media, sampler);
        });
    writeImage(output, picture.mean);
    if (!variance.empty()) writeImage(variance, picture.variance);
  });
}
