// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "data/model.h"

namespace boxlight::data {

using Parameters = std::map<std::string, double>;

struct SceneRecipe {
  std::string name, about;
  Parameters defaults;
  Model (*make)(const Parameters&);
};

const std::vector<SceneRecipe>& sceneRecipes();

/// The scene with its charts packed. `changes` replace the recipe's defaults. Errors: ExitCode::usage for an
/// unknown name or parameter, naming those that exist.
Model makeScene(const std::string& name, const Parameters& changes = {});

}  // namespace boxlight::data
