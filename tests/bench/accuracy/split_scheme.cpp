// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/split_scheme.h"

#include "bake/kernels/box_fit.h"
#include "bake/kernels/visibility_trace.h"
#include "bake/transport/bsdf.h"
#include "common/light/light_domain.h"
#include "common/light/lobe_boxes.h"

namespace boxlight::accuracy {
namespace {

constexpr uint32_t kLobeStream = 0x50000u, kMapStream = 0x60000u, kCellStream = 0x70000u;

dvec3 meanLight(const SummedArea& light, const Rectangle& rectangle) {
  return light.integrate(rectangle) / rectangle.solidAngle();
}

/// A pixel of a sharp lobe sees much less than its texel.
uint32_t pixelsFor(const asset::TexelRecord& record) { return record.roughness < 0.25f ? 256 : 64; }

}  // namespace

SplitTexel::SplitTexel(const LabScene& scene, const Subject& subject, const SplitOptions& options)
    : scene_(scene),
      subject_(subject),
      options_(options),
      origin_(subject.plan.origin(scene.world(), scene.map())),
      map_(traceVisibility(scene.world(), origin_, {9, subject.plan.texel, kMapStream})),
      visibleCells_(FilteredVisibility{{&map_}, {1.0f}}),
      cells_(std::max(options.cells, 1u)) {
  if (options_.pixels == 0) options_.pixels = pixelsFor(subject.plan.record);
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

std::vector<Box> SplitTexel::hidden(uint32_t view) const {
  KernelPaths paths;
  scene_.trace(subject_, Gloss::sharp, scene_.sphere().directions()[view], view, options_.paths, paths);
  paths.removeMirrored();
  return BoxFitter({.boxes = int(options_.hiddenBoxes)}).fit(paths.deposits, paths.traced);
}

std::vector<SeenLobe> SplitTexel::seen(vec3 direction, uint32_t pixel,
                                       const std::vector<ProbeLight>& lights) const {
  const GgxLobe own = lobe(direction, pixel);
  const FilteredVisibility visibility{{&map_}, {1.0f}};
  std::vector<SeenLobe> seen;
  if (std::min(own.alpha.x, own.alpha.y) > kWideFrom) {
    for (const ProbeLight& light : lights)
      seen.push_back(seeLobe(own, visibility, visibleCells_, light.area));
    return seen;
  }
  const ClippedLobe clipped = clipLobe(lobeBoxes(own), visibility);
  for (const ProbeLight& light : lights) {
    seen.push_back({dvec3(0.0), clipped.hidden, clipped.towards});
    for (const auto& [rectangle, energy] : clipped.pieces)
      seen.back().radiance += energy * meanLight(light.area, rectangle);
  }
  return seen;
}

double SplitTexel::hiddenPart(vec3 direction) const {
  double hidden = 0;
  const FilteredVisibility visibility{{&map_}, {1.0f}};
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel)
    hidden += clipLobe(lobeBoxes(lobe(direction, pixel)), visibility).hidden;
  return hidden / options_.pixels;
}

const SplitTexel::Stored& SplitTexel::cell(uint32_t vertex) {
  const auto [place, isNew] = known_.try_emplace(vertex);
  if (!isNew) return place->second;
  const float alpha = subject_.plan.record.roughness * subject_.plan.record.roughness;
  const DirectionCell cell{cells_.directions()[vertex], 1.0f - 2.0f / float(cells_.viewCount()), alpha};
  KernelPaths paths;
  const StreamKey key{7, subject_.plan.texel, kCellStream + vertex};
  PathTracer(scene_.world(), {}).traceIncident(origin_, cell, key, options_.paths, paths);
  place->second = {BoxFitter({.boxes = int(options_.hiddenBoxes)}).fit(paths.deposits, paths.traced),
                   double(paths.hiddenPart())};
  return place->second;
}

SplitTexel::Stored SplitTexel::cellsAround(vec3 direction) {
  const ViewBlend blend = cells_.locate(direction);
  Stored sum;
  for (int k = 0; k < 3; ++k) {
    const Stored& one = cell(blend.view[k]);
    sum.part += double(blend.weight[k]) * one.part;
    for (Box box : one.boxes) {
      box.energy *= blend.weight[k];
      sum.boxes.push_back(box);
    }
  }
  return sum;
}

SplitTexel::Stored SplitTexel::viewsAround(vec3 direction) {
  const ViewBlend blend = scene_.sphere().locate(direction);
  Stored sum;
  for (int k = 0; k < 3; ++k) {
    const double part = hiddenPart(scene_.sphere().directions()[blend.view[k]]);
    if (part < double(KernelOptions::kLeastHiddenPart)) continue;
    sum.part += double(blend.weight[k]) * part;
    for (Box box : hidden(blend.view[k])) {
      box.energy *= blend.weight[k];
      sum.boxes.push_back(box);
    }
  }
  return sum;
}

Radiances SplitTexel::relight(vec3 direction, const std::vector<ProbeLight>& lights) {
  Radiances mean(lights.size(), dvec3(0.0));
  Stored stored;
  if (!options_.cells) stored = viewsAround(direction);
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel) {
    const std::vector<SeenLobe> seenLobes = seen(direction, pixel, lights);
    if (options_.cells) stored = cellsAround(seenLobes.front().hiddenDirection());
    for (size_t l = 0; l < lights.size(); ++l) {
      dvec3 fromHidden(0.0);
      for (const Box& box : stored.boxes)
        fromHidden += dvec3(box.energy) * meanLight(lights[l].area, rectangleOf(box));
      mean[l] += splitRadiance(seenLobes[l].radiance, seenLobes[l].hidden, fromHidden, stored.part) /
                 double(options_.pixels);
    }
  }
  return mean;
}

}  // namespace boxlight::accuracy
