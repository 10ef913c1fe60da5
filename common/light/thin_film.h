// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

namespace boxlight {

/// What a thin film between air and a base reflects, per channel, [0,1]: the Airy series of Belcour and
/// Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", ACM TOG
/// 36(4), 2017, with two orders beyond the constant one, their fitted colour matching functions, and
/// Schlick's terms at both boundaries, as KHR_materials_iridescence has it.
///   cosine     of the half vector to the view, outside, [0,1]
///   filmIor    at least 1
///   thickness  nanometres; below 30 the film's index fades to that of air. (At grazing angles Schlick's term
///   does not
///              fade with it: a film of thickness 0 is to be left out by the caller.)
///   baseF0     of the base below the film, in air
Rgb thinFilmReflectance(float cosine, float filmIor, float thickness, Rgb baseF0);

/// The F0 from which Schlick's term to F90 = 1 gives `reflectance` at that cosine, [0,1]: how a pixel, whose
/// albedo table knows Schlick's terms only, takes a film.
Rgb schlickF0(Rgb reflectance, float cosine);

}  // namespace boxlight
