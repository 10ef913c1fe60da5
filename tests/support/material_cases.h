// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bake/transport/bsdf.h"

namespace boxlight::test {

/// A material, what its surface separates, and how its coat is tilted.
struct MaterialCase {
  std::string name;
  MaterialSample material;
  Interface interface {};
  vec3 coatNormal{0, 0, 1};
  float azimuth = 0;  ///< of the view: the anisotropy's direction is at 0

  Bsdf bsdf(vec3 wo) const { return {material, wo, interface, coatNormal}; }
};

/// Every lobe alone and every way to layer them, alpha from 1e-4 to 1.
const std::vector<MaterialCase>& materialCases();

}  // namespace boxlight::test
