// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/gltf_members.h"

namespace boxlight {

/// The medium behind a surface: absorption and scattering coefficients in 1/m from KHR_materials_volume and,
/// where it scatters, from KHR_materials_volume_scatter (a draft: this file is where its ratified form goes)
/// or the same members in the material's extras.boxlight_scatter, which also takes the coefficients
/// themselves (`scattering`, `absorption`). False if the surface is a thin wall (thicknessFactor 0), which
/// holds no medium. Reads what KHR_materials_transmission and KHR_materials_diffuse_transmission have set in
/// `extension`, to warn of a medium that no light enters.
bool readMedium(const GltfMembers& material, asset::MaterialExtension& extension);

/// Single-scattering albedo of a dense medium that shows the colour c when light scatters many times in it:
/// Kulla and Conty, "Revisiting Physically Based Shading at Imageworks" (SIGGRAPH 2017 course), for the
/// Henyey-Greenstein anisotropy g. c in [0,1], g in (-1,1); the result is in [0,1].
double singleScatteringAlbedo(double c, double g);

}  // namespace boxlight
