// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "bake/kernels/texel_bake.h"
#include "common/light/wide_lobe.h"
#include "tests/bench/accuracy/lab_scene.h"

namespace boxlight::accuracy {

/// Glossy transport as the direct lobe of the exact view, clipped by the texel's visibility, plus what
/// arrives from hidden directions, stored for the views:
///   L = what is seen of the lobe (wide_lobe.h: seeLobe)
///     + H(wo) sum_k b_k I_k / sum_k b_k H_k,   H what is hidden of it,
/// k the three nearest views, b_k their barycentric weights;
/// views with H_k below KernelOptions::kLeastHiddenPart store nothing. The lobe is that of several points of
/// the texel, in turn, as pixels shade their own.
struct SplitOptions {
  uint32_t hiddenBoxes = KernelOptions{}.hiddenBoxes(false);
  uint32_t pixels =
      0;  ///< points of the texel that shade their own lobe; 0: 256 of sharp lobes, 64 of others
  uint32_t paths = 1024;
  uint32_t cells = 0;  ///< frequency of the geodesic sphere of direction cells; 0: hidden parts of the views
};

class SplitTexel {
 public:
  SplitTexel(const LabScene& scene, const Subject& subject, const SplitOptions& options);
  Radiances relight(vec3 direction, const std::vector<ProbeLight>& lights);

 private:
  struct Stored {
    std::vector<Box> boxes;
    double part = 0;
  };
  const Stored& cell(uint32_t vertex);
  Stored cellsAround(vec3 direction);
  Stored viewsAround(vec3 direction);
  GgxLobe lobe(vec3 direction, uint32_t pixel) const;
  std::vector<Box> hidden(uint32_t view) const;
  /// Under each light.
  std::vector<SeenLobe> seen(vec3 direction, uint32_t pixel, const std::vector<ProbeLight>& lights) const;
  double hiddenPart(vec3 direction) const;  ///< H

  const LabScene& scene_;
  const Subject& subject_;
  SplitOptions options_;
  PathOrigin origin_;
  VisibilityMap map_;
  VisibleCells visibleCells_;
  ViewSphere cells_;
  std::map<uint32_t, Stored> known_;
};

}  // namespace boxlight::accuracy
