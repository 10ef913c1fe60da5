// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_fit.h"
#include "tests/bench/accuracy/basis.h"

namespace boxlight::accuracy {

Basis boxBasis(const std::vector<ProbeLight>& lights, uint32_t boxes) {
  return {"boxes", boxes, boxes * kBytesOfBox, [&lights, boxes](const KernelPaths& paths) {
            BoxFitter fitter({.boxes = int(boxes)});
            Radiances radiance(lights.size(), dvec3(0.0));
            for (const Box& fitted : fitter.fit(paths.deposits, paths.traced)) {
              const Box box = unpackBox(packBox(fitted));
              for (size_t l = 0; l < lights.size(); ++l)
                radiance[l] += dvec3(box.energy) * lights[l].area.integrate(box, 0.0) / box.solidAngle();
            }
            return radiance;
          }};
}

}  // namespace boxlight::accuracy
