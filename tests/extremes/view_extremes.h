// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/extremes/extreme_maps.h"
#include "tests/runtime/synthetic.h"

namespace boxlight::test {

/// Whole frames of synthetic assets, and the oracle that they are held to.
class ViewExtremes : public GpuTest {
 protected:
  static Box boxOf(const GridBox& b, Rgb energy);
  /// From `eye` along `forward`.
  static Camera cameraAlong(vec3 eye, vec3 forward, uint32_t edge, float degrees);
  /// Looks at the origin from `eye`.
  static Camera cameraAt(vec3 eye, uint32_t edge, float degrees);
  /// Every visible record's radiance with settings_ against the oracle; the largest relative error.
  double worstAgainstOracle(const asset::AssetReader& reader, const Image& environment);

  gpu::FrameSettings settings_;
};

}  // namespace boxlight::test
