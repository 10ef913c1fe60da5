// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/light/summed_area.h"

namespace boxlight::accuracy {

/// A light that kernels are tested under, at the resolution of the summed-area table: constant inside its
/// texels.
struct ProbeLight {
  std::string name;
  bool sunLit;  ///< more than a quarter of its energy comes from a thousandth of the sphere
  Image map;    ///< RGB, mean radiance 1 over the sphere
  SummedArea area;
};

struct ProbeOptions {
  uint32_t rotations = 3;  ///< random rotations of every image
  uvec2 size{512, 256};
};

/// The images blurred by a Gaussian of 1.5 pixels of a 1024 x 512 image (a sun of one texel is no light that
/// was photographed) and scaled to mean 1, each at random rotations. The same files give the same lights.
std::vector<ProbeLight> makeProbeLights(const std::vector<std::filesystem::path>& files,
                                        const ProbeOptions& options);

}  // namespace boxlight::accuracy
