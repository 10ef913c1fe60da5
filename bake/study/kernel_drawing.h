// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bake/study/kernel_study.h"

namespace boxlight {

/// An SVG of the light domain (u to the right, v down), 1024 x 512 and a caption: cells that the texel's
/// visibility map hides, one dot a deposit whose area is its luminance, boxes filled by weight over them, and
/// marks at the texel's normal (n), the view (v) and its mirror direction (m).
std::string drawKernel(const KernelStudy& study);

}  // namespace boxlight
