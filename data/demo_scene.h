// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "data/scenes.h"

namespace boxlight::data {

/// The demo: Newell's teapot, 32 cm wide, in copper with GGX alpha .04, three Lambert balls that it reflects
/// and that catch its light, on a slab. Parameters: `roughness` of the copper, `ground_density` and
/// `ball_density`, texels per metre relative to the teapot's.
Parameters demoSceneDefaults();
Model makeDemoScene(const Parameters& parameters);

}  // namespace boxlight::data
