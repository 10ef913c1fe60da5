// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>

#include "bake/kernels/texel_bake.h"
#include "common/light/wide_lobe.h"
#include "tests/bench/accuracy/lab_scene.h"

namespace boxlight::accuracy {

/// A texel seen from one direction under the schemes split and cells: the direct lobe, behind the texel's
/// visibility, plus what arrives from hidden directions, stored for the views or for those directions
/// (lobe_clip.h: splitRadiance). The lobe is that of several points of the texel, in turn, as pixels shade
/// their own: 256 of sharp lobes, which see much less than the texel, and 64 of others.
class SplitTexel {
 public:
  SplitTexel(const LabScene& scene, const Subject& subject, vec3 direction,
             const std::vector<ProbeLight>& lights, uint32_t paths);

  /// Of the views that a bake gives the texel (kViewsByRoughness).
  uint32_t usualFrequency() const;
  /// With kernels of this many boxes for the three nearest views of a sphere of this frequency (3: 92); those
  /// that hide less than KernelOptions::leastHiddenPart have none.
  Radiances byViews(uint32_t boxes, uint32_t frequency);
  /// With kernels for the directions of a geodesic sphere.
  Radiances byCells(uint32_t frequency, uint32_t boxes) const;

 private:
  struct Stored {
    std::vector<Box> boxes;
    double part = 0;  ///< H
  };
  using StoredAt = std::function<Stored(uint32_t vertex)>;
  static Stored around(const ViewSphere& sphere, vec3 direction, const StoredAt& at);
  GgxLobe lobe(vec3 direction, uint32_t pixel) const;
  const KernelPaths& pathsOf(const ViewSphere& sphere, uint32_t view);
  Radiances relight(const std::function<Stored(const SeenLobe&)>& stored) const;

  const LabScene& scene_;
  const Subject& subject_;
  vec3 direction_;
  const std::vector<ProbeLight>& lights_;
  uint32_t paths_;
  PathOrigin origin_;
  VisibilityMap map_;
  std::vector<std::vector<SeenLobe>> pixels_;                       ///< under each light
  std::map<std::pair<uint32_t, uint32_t>, KernelPaths> viewPaths_;  ///< by number of views, and view
};

}  // namespace boxlight::accuracy
