// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/reference.h"

#include <tbb/parallel_for.h>

#include "bake/transport/bsdf.h"
#include "bake/transport/reference_integrator.h"

namespace boxlight {
namespace {

constexpr uint32_t kPictureStream = 0xFFFFFFFFu;  ///< apart from every stream of a bake
constexpr int kMaximumLayers = 64;                ///< culled faces that a camera ray passes

/// Running mean and variance: Welford, "Note on a method for calculating corrected sums of squares",
/// Technometrics 4(3), 1962.
struct PixelSum {
  void add(Rgb radiance, float alpha) {
    ++count;
    const dvec3 delta = dvec3(radiance) - mean;
    mean += delta / double(count);
    squares += delta * (dvec3(radiance) - mean);
    coverage += (double(alpha) - coverage) / double(count);
  }
  Rgb varianceOfMean() const {
    return count > 1 ? Rgb(squares / double(count) / double(count - 1)) : Rgb(0.0f);
  }

  uint64_t count = 0;
  dvec3 mean{0.0}, squares{0.0};
  double coverage = 0;
};

/// Luminance of a row's samples, and what the limit took of it.
struct RowEnergy {
  double all = 0, removed = 0;
};

Rgb limited(Rgb radiance, float limit, RowEnergy& energy) {
  const float largest = maxComponent(radiance);
  energy.all += double(luminance(radiance));
  if (!(largest > limit)) return radiance;
  const Rgb kept = radiance * (limit / largest);
  energy.removed += double(luminance(radiance - kept));
  return kept;
}

/// What a camera ray meets.
struct CameraHit {
  std::optional<SurfacePoint> point;
  PathState path;  ///< its direction turns where a medium scatters it
};

/// Through the medium that the camera is in, and through the faces that it does not see.
CameraHit followCamera(const Intersector& world, Ray ray, const MediumStack& media, Sampler& sampler) {
  const Scene& scene = world.scene();
  PathState path{ray.direction, Rgb(1.0f), media};
  for (int layer = 0; layer < kMaximumLayers; ++layer) {
    const Travel next = travel(world, path.media, ray, path.throughput, sampler);
    path.direction = ray.direction;
    if (!next.point) return {std::nullopt, path};
    const uint32_t material = scene.triangles[next.point->triangle].material;
    const uint32_t flags = scene.materials[material].flags;
    const vec3 normal = surfaceFrame(scene, *next.point).geometricNormal;
    const bool back = glm::dot(normal, ray.direction) > 0.0f;
    if (!back || next.scattered || flags & asset::kDoubleSided) return {next.point, path};
    if (flags & asset::kVolume) path.media.leave(material);
    ray.origin = offsetOrigin(scene, *next.point, normal);
    ray.limit = std::numeric_limits<float>::infinity();
  }
  return {std::nullopt, path};
}

}  // namespace

ReferencePicture renderPicture(const Intersector& world, const EnvironmentSampler& environment,
                               const Camera& camera, const ReferenceOptions& options,
                               const RadianceEstimator& estimate) {
  const uvec2 size = camera.size;
  ReferencePicture picture{makeImage(size.x, size.y, 4), makeImage(size.x, size.y, 3)};
  const MediumStack media = enclosingMedia(world, {camera.eye, -camera.forward});
  std::vector<RowEnergy> rows(size.y);
  Progress progress("render", size.y, options.progress);
  auto renderPixel = [&](uint32_t x, uint32_t y) {
    PixelSum sum;
    for (uint32_t s = 0; s < options.samplesPerPixel; ++s) {
      Sampler sampler({options.seed, y * size.x + x, kPictureStream}, s);
      const Ray ray{camera.eye, camera.direction(vec2(x, y) + sampler.next2())};
      const auto [point, path] = followCamera(world, ray, media, sampler);
      if (point && maxComponent(path.throughput) > 0.0f)
        sum.add(limited(path.throughput * estimate(*point, path.direction, path.media, sampler),
                        options.radianceLimit, rows[y]),
                1.0f);
      else if (point)
        sum.add(Rgb(0.0f), 1.0f);
      else if (options.background)
        sum.add(path.throughput * environment.radiance(path.direction), 1.0f);
      else
        sum.add(Rgb(0.0f), 0.0f);
    }
    const Rgb variance = sum.varianceOfMean();
    for (int c = 0; c < 3; ++c) {
      picture.mean.at(x, y)[c] = float(sum.mean[c]);
      picture.variance.at(x, y)[c] = variance[c];
    }
    picture.mean.at(x, y)[3] = float(sum.coverage);
  };
  tbb::parallel_for(0u, size.y, [&](uint32_t y) {
    for (uint32_t x = 0; x < size.x && !interrupted(); ++x) renderPixel(x, y);
    progress.advance();
  });
  throwIfInterrupted("interrupted: no picture was written");
  RowEnergy total;
  for (const RowEnergy& row : rows) total.all += row.all, total.removed += row.removed;
  picture.removed = total.all > 0.0 ? total.removed / total.all : 0.0;
  return picture;
}

ReferencePicture renderReference(const Intersector& world, const EnvironmentSampler& environment,
                                 const Camera& camera, const ReferenceOptions& options) {
  const ReferenceIntegrator<Bsdf> integrator(world, environment, options.bounces);
  return renderPicture(
      world, environment, camera, options,
      [&](const SurfacePoint& point, vec3 direction, const MediumStack& media, Sampler& sampler) {
        return integrator.radiance(point, direction, media, sampler);
      });
}

}  // namespace boxlight
