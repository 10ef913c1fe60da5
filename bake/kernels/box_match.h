// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/base/math.h"
#include "common/light/box.h"
#include "common/light/view_sphere.h"

namespace boxlight {

/// One slot order for all views of a texel, so that box j of a view corresponds to box j of its neighbours
/// and box parameters can be interpolated between views. kernels[v] holds the boxes of view v, at most
/// `slots`; empty if the view is not stored. On return every stored kernel has exactly `slots` boxes. A slot
/// that a view lacks is filled with an empty box (energy 0) shaped like its neighbour's, so that
/// interpolation fades it out in place. Slots are in order of falling energy summed over the views.
void matchSlots(const ViewSphere& sphere, vec3 normal, std::vector<std::vector<Box>>& kernels, int slots);

}  // namespace boxlight
