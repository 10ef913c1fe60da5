// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/support/scenes.h"

namespace boxlight::test {

/// A material of the scene's own records.
struct SceneMaterial {
  std::string name;
  asset::Material material;
  asset::MaterialExtension extension;

  Scene scene() const;
};

/// One of each kind, rough enough that directions drawn uniformly find its lobes; all of them double-sided,
/// none a volume.
const std::vector<SceneMaterial>& sceneMaterials();

/// White glass of a volume.
SceneMaterial glassVolume(float roughness);

}  // namespace boxlight::test
