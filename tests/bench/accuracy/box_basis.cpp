// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_fit.h"
#include "bake/kernels/texel_bake.h"
#include "common/light/relight.h"
#include "tests/bench/accuracy/basis.h"

namespace boxlight::accuracy {
namespace {

Radiances relightBoxes(const KernelPaths& paths, const std::vector<ProbeLight>& lights, uint32_t boxes) {
  Radiances radiance(lights.size(), dvec3(0.0));
  if (boxes == 0) return radiance;
  BoxFitter fitter({.boxes = int(boxes)});
  for (const Box& fitted : fitter.fit(paths.deposits, paths.traced)) {
    const Box box = unpackBox(packBox(fitted));
    for (size_t l = 0; l < lights.size(); ++l)
      radiance[l] += dvec3(box.energy) * lights[l].area.integrate(box, 0.0) / box.solidAngle();
  }
  return radiance;
}

Radiances relightLambert(KernelPaths paths, vec3 normal, const std::vector<ProbeLight>& lights,
                         uint32_t boxes) {
  std::vector<CosineBox> straight;
  for (const CosineBox& box : VisibilityFitter(straightFit(boxes)).fit(paths.first, normal))
    straight.push_back(unpackCosineBox(packCosineBox(box)));
  paths.removeStraight();
  Radiances radiance = relightBoxes(paths, lights, boxes - uint32_t(straight.size()));
  for (size_t l = 0; l < lights.size(); ++l)
    radiance[l] += straightRadiance(straight, dvec3(normal), lights[l].area).radiance;
  return radiance;
}

}  // namespace

Basis boxBasis(const std::vector<ProbeLight>& lights, uint32_t boxes) {
  return {"boxes", boxes, boxes * kBytesOfBox,
          [&lights, boxes](const KernelPaths& paths, vec3) { return relightBoxes(paths, lights, boxes); }};
}

Basis lambertBasis(const std::vector<ProbeLight>& lights, uint32_t boxes) {
  return {"boxes", boxes, boxes * kBytesOfBox, [&lights, boxes](const KernelPaths& paths, vec3 normal) {
            return relightLambert(paths, normal, lights, boxes);
          }};
}

}  // namespace boxlight::accuracy
