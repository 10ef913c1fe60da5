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
  Rgb f0{1.0f}, f90{1.0f};  ///< Schlick's Fresnel factor f0 + (f90 - f0) (1 - v.h)^5
  bool filmed = false;      ///< f0 and f90 are those of a line (film_lobe.h): what it says is clamped
};

/// Of the factor of a filmed lobe: what reflects nothing has no shape.
inline constexpr float kLeastFilmed = 1e-3f;

inline constexpr uint32_t kLobeBoxes = 18, kLobeSamples = 4;

/// What a box is made from: the random numbers that its directions are drawn with (ggx.h:
/// sampleVisibleNormal), the part of the unit square that they stand for, and how much wider the box is than
/// a uniform one with their spread.
struct LobeCell {
  std::array<vec2, kLobeSamples> random;
  float area = 0, spread = 1;
};
using LobeCells = std::array<LobeCell, kLobeBoxes>;

/// A core, four rings of four and a tail, for lobes that are about as wide as high; or strips across local x.
const LobeCells& roundCells();
const LobeCells& stripCells();
/// Strips are for lobes whose alpha along x is more than this times the other: boxes that are aligned with
/// the light domain cannot follow a narrow streak any other way.
inline constexpr float kStripRatio = 2;

/// Local x of an isotropic lobe that its boxes are best aligned with: half vectors that differ along it
/// reflect to directions that differ in u.
vec3 lobeTangent(vec3 normal, vec3 view);

/// The lobe f cos / (its directional albedo, both without Fresnel) as boxes whose energies sum to 1: no fit,
/// no table, continuous in everything that it depends on.
///   The square of random numbers that sampleVisibleNormal takes is cut into cells. Each becomes the box with
///   the mean and the spread of reflected directions in it; a uniform box of width d has a variance of
///   d^2 / 12, a uniform arc of d turns the mean vector sin(pi d) / (pi d). A box's energy is the mean of
///   F G2 / G1 times its cell's area.
std::array<Box, kLobeBoxes> lobeBoxes(const GgxLobe& lobe);

/// A lattice of points of the unit square, Fibonacci's.
inline constexpr uint32_t kAlbedoSamples = 34, kAlbedoStep = 21;

/// The lobe's directional albedo, Fresnel factor included: what the directional albedo of a pixel, which
/// knows no anisotropy, is put right with. Within 5 %, 1.5 % root mean square over roughness, strength and
/// view. (That of the boxes' own directions is up to 12 % too much where a view grazes along a streak.)
Rgb lobeAlbedo(const GgxLobe& lobe);

}  // namespace boxlight
