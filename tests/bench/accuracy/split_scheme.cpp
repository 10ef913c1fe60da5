// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/split_scheme.h"

#include "bake/kernels/box_fit.h"
#include "bake/kernels/visibility_trace.h"
#include "bake/transport/bsdf.h"
#include "common/light/light_domain.h"
#include "common/light/lobe_boxes.h"

namespace boxlight::accuracy {
namespace {

constexpr uint32_t kLobeStream = 0x50000u, kMapStream = 0x60000u;

dvec3 meanLight(const SummedArea& light, const Rectangle& rectangle) {
  return light.integrate(rectangle) / rectangle.solidAngle();
}

}  // namespace

SplitTexel::SplitTexel(const LabScene& scene, const Subject& subject, const SplitOptions& options)
    : scene_(scene),
      subject_(subject),
      options_(options),
      origin_(subject.plan.origin(scene.world(), scene.map())),
      map_(traceVisibility(scene.world(), origin_, {9, subject.plan.texel, kMapStream})) {}

/// As if nothing stood around.
std::vector<Box> SplitTexel::lobe(vec3 direction, uint32_t pixel) const {
  Sampler sampler({9, subject_.plan.texel, kLobeStream}, pixel);
  const SurfacePoint point = sampleFootprint(origin_.footprint, sampler.next2());
  const vec3 wo = raiseAboveHorizon(direction, origin_.normal);
  const SurfaceView surface = viewSurfaceSide(scene_.world().scene(), point, wo, origin_.back);
  const Bsdf bsdf(surface.material, surface.toLocal(wo));
  const bool isotropic = bsdf.alpha().x == bsdf.alpha().y;
  const vec3 tangent = isotropic ? lobeTangent(surface.normal, wo) : surface.tangent;
  const auto boxes =
      lobeBoxes({tangent, glm::cross(surface.normal, tangent), surface.normal, wo, bsdf.alpha(), bsdf.f0()});
  return {boxes.begin(), boxes.end()};
}

std::vector<Box> SplitTexel::hidden(uint32_t view) const {
  KernelPaths paths;
  scene_.trace(subject_, Gloss::sharp, scene_.sphere().directions()[view], view, options_.paths, paths);
  paths.removeMirrored();
  return BoxFitter({.boxes = int(options_.hiddenBoxes)}).fit(paths.deposits, paths.traced);
}

ClippedLobe SplitTexel::clipped(vec3 direction, uint32_t pixel) const {
  return clipLobe(lobe(direction, pixel), {{&map_}, {1.0f}});
}

double SplitTexel::hiddenPart(vec3 direction) const {
  double hidden = 0;
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel) hidden += clipped(direction, pixel).hidden;
  return hidden / options_.pixels;
}

Radiances SplitTexel::relight(vec3 direction, const std::vector<ProbeLight>& lights) const {
  Radiances radiance(lights.size(), dvec3(0.0)), fromHidden = radiance;
  const auto add = [&](Radiances& sum, dvec3 energy, const Rectangle& rectangle) {
    for (size_t l = 0; l < lights.size(); ++l) sum[l] += energy * meanLight(lights[l].area, rectangle);
  };
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel)
    for (const auto& [rectangle, energy] : clipped(direction, pixel).pieces)
      add(radiance, energy / double(options_.pixels), rectangle);
  const ViewBlend blend = scene_.sphere().locate(direction);
  double stored = 0;
  for (int k = 0; k < 3; ++k) {
    stored += double(blend.weight[k]) * hiddenPart(scene_.sphere().directions()[blend.view[k]]);
    for (const Box& box : hidden(blend.view[k]))
      add(fromHidden, double(blend.weight[k]) * dvec3(box.energy), rectangleOf(box));
  }
  const double part = hiddenPart(direction);
  for (size_t l = 0; l < lights.size(); ++l)
    radiance[l] = splitRadiance(radiance[l], part, fromHidden[l], stored);
  return radiance;
}

}  // namespace boxlight::accuracy
