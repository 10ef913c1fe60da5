// SPDX-License-Identifier: Apache-2.0
#include "tests/support/path_lab.h"

#include "bake/transport/bsdf.h"

namespace boxlight::test {
namespace {

void store(float (&target)[3], Rgb value) {
  for (int c = 0; c < 3; ++c) target[c] = value[c];
}

}  // namespace

void addBox(Scene& scene, vec3 low, vec3 high, uint32_t material) {
  const vec3 d = high - low, x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
  const auto add = [&](vec3 corner, vec3 u, vec3 v) {
    addQuad(scene, corner, u, v, vec2(0), vec2(1), material);
  };
  add(low + y, z, x);
  add(low, x, z);
  add(low, z, y);
  add(low + x, y, z);
  add(low, y, x);
  add(low + z, x, y);
}

void makeExtensions(Scene& scene) { scene.materialExtensions.resize(scene.materials.size()); }

Scene diffuseMedium(Rgb absorption, Rgb scattering, float g) {
  Scene scene = makeScene(lambert());
  scene.materials[0].flags |= asset::kVolume;
  makeExtensions(scene);
  asset::MaterialExtension& x = scene.materialExtensions[0];
  x.diffuseTransmission = 1;
  store(x.absorption, absorption);
  store(x.scattering, scattering);
  x.scatterAnisotropy = g;
  return scene;
}

Scene glass(float ior, Rgb absorption, float specular) {
  Scene scene = makeScene(lambert());
  scene.materials[0].flags |= asset::kVolume;
  scene.materials[0].specular = specular;
  scene.materials[0].roughness = 0;
  makeExtensions(scene);
  scene.materialExtensions[0].ior = ior;
  scene.materialExtensions[0].transmission = 1;
  store(scene.materialExtensions[0].absorption, absorption);
  return scene;
}

BeamExit followBeam(const Intersector& world, Ray ray, const MediumStack& media, Sampler sampler) {
  const Scene& scene = world.scene();
  PathState path{ray.direction, Rgb(1.0f), media};
  BeamExit exit;
  for (;; ++exit.bounces) {
    const Travel next = travel(world, path.media, ray, path.throughput, sampler);
    if (!next.point) {
      exit.escaped = maxComponent(path.throughput) > 0.0f;
      exit.direction = ray.direction;
      exit.origin = ray.origin;
      exit.throughput = path.throughput;
      return exit;
    }
    const SurfaceView surface = viewSurface(scene, *next.point, -ray.direction, path.media);
    const Bsdf bsdf(surface.material, surface.toLocal(-ray.direction), surface.interface, surface.coatNormal);
    if (!continuePath(exit.bounces, kUnlimitedBounces, path.throughput, sampler) ||
        scatter(surface, bsdf, path, sampler) == 0.0f)
      return exit;
    ray = leaveSurface(scene, surface, path.direction);
  }
}

KernelPaths lambertPaths(const Intersector& world, uint32_t triangle, bool back, uint32_t count,
                         uint64_t seed) {
  const FootprintPiece piece{triangle, {vec2(0, 0.5f), vec2(0.002f, 0.499f), vec2(0, 0.499f)}, 1};
  const vec3 normal = surfaceFrame(world.scene(), {triangle, vec2(1.0f / 3.0f)}).geometricNormal;
  const std::span<const FootprintPiece> footprint(&piece, 1);
  const PathOrigin origin{footprint, back, back ? -normal : normal, mediaAround(world, footprint, back)};
  KernelPaths paths;
  PathTracer(world, {}).traceLambert(origin, {seed, 0, 0}, count, paths);
  return paths;
}

Scene slab(Scene scene, float depth) {
  const float half = std::max(10 * depth, 50.0f);
  addBox(scene, {-half, -depth, -half}, {half, 0, half});
  return scene;
}

SlabAnswer slabAnswer(const KernelPaths& paths, int channel) {
  SlabAnswer answer;
  for (const Deposit& deposit : paths.deposits) {
    const bool up = deposit.uv.y < 0.5f;
    answer.reflected.add(up ? double(deposit.throughput[channel]) : 0.0);
    answer.transmitted.add(up ? 0.0 : double(deposit.throughput[channel]));
  }
  for (size_t i = paths.deposits.size(); i < paths.traced; ++i)
    answer.reflected.add(0), answer.transmitted.add(0);
  return answer;
}

}  // namespace boxlight::test
