// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "data/scenes.h"

namespace boxlight::data {

/// One scene per material, `material_NAME`, in the order of the contact sheet: the same bead, 10 cm wide, on
/// a small chequered plate, but for the leaf. The bead is a body of revolution about +Y with a groove around
/// it.
const std::vector<SceneRecipe>& materialSceneRecipes();

}  // namespace boxlight::data
