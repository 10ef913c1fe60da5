// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/split_scheme.h"

#include <cmath>

#include "bake/kernels/box_fit.h"
#include "bake/transport/bsdf.h"
#include "common/light/light_domain.h"
#include "common/light/lobe_boxes.h"

namespace boxlight::accuracy {
namespace {

constexpr uint32_t kLobeStream = 0x50000u, kMapStream = 0x60000u;

/// A piece of a lobe's box: what is visible of a rectangle, and the energy of that.
struct Piece {
  VisibleRectangle part;
  dvec3 density;  ///< energy per steradian of the box it comes from

  double urgency() const {
    const double area = part.rectangle.solidAngle();
    if (area <= 0) return 0;
    const double f = std::min(part.visible / area, 1.0);
    return density.y * std::pow(area, 1.25) * f * (1 - f);
  }
};

/// Halves the pieces whose hidden parts hurt most.
std::vector<Piece> clip(const std::vector<Box>& lobe, const VisibilityMap& map, uint32_t most) {
  std::vector<Piece> pieces;
  for (const Box& box : lobe)
    pieces.push_back({shrinkToVisible(rectangleOf(box), map), dvec3(box.energy) / box.solidAngle()});
  while (pieces.size() < most) {
    const auto worst = std::max_element(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return a.urgency() < b.urgency();
    });
    if (worst == pieces.end() || worst->urgency() <= 1e-9) break;
    Rectangle first = worst->part.rectangle, second = first;
    const double sine = std::sin(kPiDouble * (first.v0 + 0.5 * first.dv));
    if (2 * first.du * sine > first.dv)
      first.du = second.du = 0.5 * first.du, second.u0 += first.du;
    else
      first.dv = second.dv = 0.5 * first.dv, second.v0 += first.dv;
    const dvec3 density = worst->density;
    *worst = {shrinkToVisible(first, map), density};
    pieces.push_back({shrinkToVisible(second, map), density});
  }
  return pieces;
}

dvec3 meanLight(const SummedArea& light, const Rectangle& rectangle) {
  return light.integrate(rectangle) / rectangle.solidAngle();
}

}  // namespace

SplitTexel::SplitTexel(const LabScene& scene, const Subject& subject, const SplitOptions& options)
    : scene_(scene),
      subject_(subject),
      options_(options),
      origin_(subject.plan.origin(scene.world(), scene.map())) {
  const StreamKey key{9, subject.plan.texel, kMapStream};
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x) {
      Sampler sampler(key, y * VisibilityMap::kColumns + x);
      const SurfacePoint point = sampleFootprint(origin_.footprint, sampler.next2());
      const vec2 uv = (vec2(x, y) + sampler.next2()) / vec2(VisibilityMap::kColumns, VisibilityMap::kRows);
      const SurfaceView surface = viewSurfaceSide(scene.world().scene(), point, origin_.normal, origin_.back);
      const vec3 direction = uvToDirection(uv);
      if (dot(direction, surface.geometricNormal) > 0 &&
          !scene.world().occluded(leaveSurface(scene.world().scene(), surface, direction)))
        map_.setVisible(x, y);
    }
}

/// As if nothing stood around.
std::vector<Box> SplitTexel::lobe(vec3 direction, uint32_t pixel) const {
  Sampler sampler({9, subject_.plan.texel, kLobeStream}, pixel);
  const SurfacePoint point = sampleFootprint(origin_.footprint, sampler.next2());
  const vec3 wo = raiseAboveHorizon(direction, origin_.normal);
  const SurfaceView surface = viewSurfaceSide(scene_.world().scene(), point, wo, origin_.back);
  const Bsdf bsdf(surface.material, surface.toLocal(wo));
  const auto boxes =
      lobeBoxes({surface.tangent, surface.bitangent, surface.normal, wo, bsdf.alpha(), bsdf.f0()});
  return {boxes.begin(), boxes.end()};
}

std::vector<Box> SplitTexel::hidden(uint32_t view) const {
  KernelPaths paths;
  scene_.trace(subject_, Gloss::sharp, scene_.sphere().directions()[view], view, options_.paths, paths);
  std::erase_if(paths.deposits, [](const Deposit& deposit) { return deposit.direct; });
  return BoxFitter({.boxes = int(options_.hiddenBoxes)}).fit(paths.deposits, paths.traced);
}

double SplitTexel::hiddenPart(vec3 direction) const {
  double hidden = 0;
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel)
    for (const Box& box : lobe(direction, pixel)) {
      const double visible = shrinkToVisible(rectangleOf(box), map_).visible / box.solidAngle();
      hidden += double(box.energy.y) * std::max(1 - visible, 0.0);
    }
  return hidden / options_.pixels;
}

Radiances SplitTexel::relight(vec3 direction, const std::vector<ProbeLight>& lights) const {
  Radiances radiance(lights.size(), dvec3(0.0)), fromHidden = radiance;
  const auto add = [&](Radiances& sum, dvec3 energy, const Rectangle& rectangle) {
    for (size_t l = 0; l < lights.size(); ++l) sum[l] += energy * meanLight(lights[l].area, rectangle);
  };
  for (uint32_t pixel = 0; pixel < options_.pixels; ++pixel)
    for (const Piece& piece : clip(lobe(direction, pixel), map_, options_.pieces))
      if (piece.part.visible > 0)
        add(radiance, piece.density * piece.part.visible / double(options_.pixels), piece.part.rectangle);
  const ViewBlend blend = scene_.sphere().locate(direction);
  double stored = 0;
  for (int k = 0; k < 3; ++k) {
    stored += double(blend.weight[k]) * hiddenPart(scene_.sphere().directions()[blend.view[k]]);
    for (const Box& box : hidden(blend.view[k]))
      add(fromHidden, double(blend.weight[k]) * dvec3(box.energy), rectangleOf(box));
  }
  const double scale = stored > 1e-6 ? hiddenPart(direction) / stored : 0.0;
  for (size_t l = 0; l < lights.size(); ++l) radiance[l] += scale * fromHidden[l];
  return radiance;
}

}  // namespace boxlight::accuracy
