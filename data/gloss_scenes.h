// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "data/scenes.h"

namespace boxlight::data {

/// The scenes that accuracy is measured on beside the demo (docs/accuracy.md): Lambert, metal and dielectric
/// of GGX alpha .02 to .4, where neighbours hide and reflect each other.
const std::vector<SceneRecipe>& glossSceneRecipes();

}  // namespace boxlight::data
