// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "common/light/lobe_boxes.h"

// A thin film in a pixel's own lobe, the oracle of shaders/film.glsl.

namespace boxlight {

/// Gives a lobe a Fresnel factor that Schlick's form does not have, such as a film's: the line in
/// (1 - v.h)^5 through its values at the mean of v.h less and plus the standard deviation, both of four
/// visible normals. What all of a rough lobe reflects is then within .02, of a sharp one (alpha .01) within
/// .003, where the value at n.v alone is off by up to .4 under grazing views: half vectors lean to the view.
///   fresnel  by v.h; [0,1]
void fitFresnel(GgxLobe& lobe, const std::function<Rgb(float)>& fresnel);

/// The directional albedo of a fitted lobe, from those of F0 = 1 and of F90 = 1 alone.
Rgb filmedAlbedo(const GgxLobe& lobe, vec2 albedo);

}  // namespace boxlight
