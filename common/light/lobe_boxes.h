// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "common/light/box.h"

namespace boxlight {

/// A GGX reflection lobe: unit vectors in world space, local x and y along alpha's components, `view` away
/// from the surface and above its horizon.
struct GgxLobe {
  vec3 tangent{1, 0, 0}, bitangent{0, 0, -1}, normal{0, 1, 0}, view{0, 1, 0};
  vec2 alpha{0.1f};
  Rgb f0{1.0f};  ///< Schlick's Fresnel factor f0 + (f90 - f0) (1 - v.h)^5
  float f90 = 1;
};

inline constexpr uint32_t kLobeBoxes = 10;

/// The lobe f cos / (its directional albedo, both without Fresnel) as boxes whose energies sum to 1: no fit,
/// no table, continuous in everything that it depends on.
///   The square of random numbers that sampleVisibleNormal (ggx.h) takes is cut into kLobeBoxes cells: a
///   core, two rings of four and a tail. Each becomes the box with the mean and 1.1 times the spread of 3 x 3
///   reflected directions in it; a uniform box of width d has a variance of d^2 / 12, a uniform arc of d
///   turns the mean vector sin(pi d) / (pi d). A box's energy is the mean of F G2 / G1 times its cell's area.
std::array<Box, kLobeBoxes> lobeBoxes(const GgxLobe& lobe);

}  // namespace boxlight
