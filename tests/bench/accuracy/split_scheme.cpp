// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/split_scheme.h"

#include "bake/kernels/box_fit.h"
#include "bake/kernels/visibility_trace.h"
#include "bake/transport/bsdf.h"
#include "common/light/light_domain.h"

namespace boxlight::accuracy {
namespace {

constexpr uint32_t kLobeStream = 0x50000u, kMapStream = 0x60000u, kCellStream = 0x70000u,
                   kViewStream = 0x80000u;

dvec3 meanLight(const SummedArea& light, const Rectangle& rectangle) {
  return light.integrate(rectangle) / rectangle.solidAngle();
}

std::vector<Box> fit(const KernelPaths& paths, uint32_t boxes) {
  return BoxFitter({.boxes = int(boxes)}).fit(paths.deposits, paths.traced);
}

}  // namespace

SplitTexel::SplitTexel(const LabScene& scene, const Subject& subject, vec3 direction,
                       const std::vector<ProbeLight>& lights, uint32_t paths)
    : scene_(scene),
      subject_(subject),
      direction_(direction),
      lights_(lights),
      paths_(paths),
      origin_(subject.plan.origin(scene.world(), scene.map())),
      map_(traceVisibility(scene.world(), origin_, {9, subject.plan.texel, kMapStream})) {
  const FilteredVisibility visibility{{&map_}, {1.0f}};
  const VisibleCells cells(visibility);
  pixels_.resize(subject.plan.record.roughness < 0.25f ? 256 : 64);
  for (uint32_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    const GgxLobe own = lobe(direction, pixel);
    for (const ProbeLight& light : lights)
      pixels_[pixel].push_back(seeLobe(own, visibility, cells, light.area));
  }
}

/// As if nothing stood around.
GgxLobe SplitTexel::lobe(vec3 direction, uint32_t pixel) const {
  Sampler sampler({9, subject_.plan.texel, kLobeStream}, pixel);
  const SurfacePoint point = sampleFootprint(origin_.footprint, sampler.next2());
  const vec3 wo = raiseAboveHorizon(direction, origin_.normal);
  const SurfaceView surface = viewSurfaceSide(scene_.world().scene(), point, wo, origin_.back);
  const Bsdf bsdf(surface.material, surface.toLocal(wo));
  const bool isotropic = bsdf.alpha().x == bsdf.alpha().y;
  const vec3 tangent = isotropic ? lobeTangent(surface.normal, wo) : surface.tangent;
  return {tangent, glm::cross(surface.normal, tangent), surface.normal, wo, bsdf.alpha(), bsdf.f0()};
}

SplitTexel::Stored SplitTexel::around(const ViewSphere& sphere, vec3 direction, const StoredAt& at) {
  const ViewBlend blend = sphere.locate(direction);
  Stored sum;
  for (int k = 0; k < 3; ++k) {
    const Stored one = at(blend.view[k]);
    sum.part += double(blend.weight[k]) * one.part;
    for (Box box : one.boxes) {
      box.energy *= blend.weight[k];
      sum.boxes.push_back(box);
    }
  }
  return sum;
}

const KernelPaths& SplitTexel::pathsOf(const ViewSphere& sphere, uint32_t view) {
  const auto [place, isNew] = viewPaths_.try_emplace({sphere.viewCount(), view});
  const bool usual = sphere.viewCount() == scene_.sphere().viewCount();
  const uint32_t stream = usual ? view : kViewStream + 512 * sphere.viewCount() + view;
  if (isNew) scene_.trace(subject_, Gloss::sharp, sphere.directions()[view], stream, paths_, place->second);
  return place->second;
}

uint32_t SplitTexel::usualFrequency() const {
  const float alpha = subject_.plan.record.roughness * subject_.plan.record.roughness;
  uint32_t frequency = scene_.sphere().frequency();
  for (const CoarseViews& coarse : kViewsByRoughness)
    if (alpha >= coarse.leastAlpha) frequency = coarse.frequency;
  return frequency;
}

Radiances SplitTexel::byViews(uint32_t boxes, uint32_t frequency) {
  const ViewSphere sphere(frequency);
  const Stored stored = around(sphere, direction_, [&](uint32_t view) -> Stored {
    KernelPaths paths = pathsOf(sphere, view);
    const double part = paths.hiddenPart();
    if (part < double(KernelOptions::leastHiddenPart(frequency < scene_.sphere().frequency()))) return {};
    paths.removeMirrored();
    return {fit(paths, boxes), part};
  });
  return relight([&](const SeenLobe&) { return stored; });
}

Radiances SplitTexel::byCells(uint32_t frequency, uint32_t boxes) const {
  const ViewSphere cells(frequency);
  std::map<uint32_t, Stored> known;
  const StoredAt cell = [&](uint32_t vertex) -> Stored {
    const auto [place, isNew] = known.try_emplace(vertex);
    if (!isNew) return place->second;
    const float alpha = subject_.plan.record.roughness * subject_.plan.record.roughness;
    const DirectionCell at{cells.directions()[vertex], 1.0f - 2.0f / float(cells.viewCount()), alpha};
    KernelPaths paths;
    const StreamKey key{7, subject_.plan.texel, kCellStream + vertex};
    PathTracer(scene_.world(), {}).traceIncident(origin_, at, key, paths_, paths);
    return place->second = {fit(paths, boxes), double(paths.hiddenPart())};
  };
  return relight([&](const SeenLobe& seen) { return around(cells, seen.hiddenDirection(), cell); });
}

/// `stored`: for what is hidden of a pixel's lobe, the same under every light.
Radiances SplitTexel::relight(const std::function<Stored(const SeenLobe&)>& stored) const {
  Radiances mean(lights_.size(), dvec3(0.0));
  for (const std::vector<SeenLobe>& pixel : pixels_) {
    const Stored behind = stored(pixel.front());
    for (size_t l = 0; l < lights_.size(); ++l) {
      dvec3 fromHidden(0.0);
      for (const Box& box : behind.boxes)
        fromHidden += dvec3(box.energy) * meanLight(lights_[l].area, rectangleOf(box));
      mean[l] +=
          splitRadiance(pixel[l].radiance, pixel[l].hidden, fromHidden, behind.part) / double(pixels_.size());
    }
  }
  return mean;
}

}  // namespace boxlight::accuracy
