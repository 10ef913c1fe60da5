// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bake/commands/transport_options.h"
#include "bake/scene/atlas.h"
#include "common/asset/asset.h"

namespace boxlight {

/// The command line of `ptbake bake`.
struct BakeOptions {
  std::string scene, output, preset = "preview", atlasUv = "auto", scheme = "auto", views = "auto";
  TransportOptions transport;
  uint32_t atlas = 0, boxes = 0, paths = 0;  ///< 0: as the preset says
  uint32_t levels = 1;
  std::vector<uint32_t> texel;  ///< x and y: study this one, bake nothing
  std::optional<uint32_t> view, cells;
  std::string side = "front";
};

void addBakeOptions(CLI::App& command, BakeOptions& options);

/// What the parser cannot say, and what the preset leaves to it. Errors: ExitCode::usage.
void finishBakeOptions(BakeOptions& options);

const std::map<std::string, AtlasSource>& atlasSources();
const std::map<std::string, asset::Scheme>& schemes();

}  // namespace boxlight
