// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/cli.h"

namespace boxlight {

/// ptbake render SCENE --env IMAGE -o OUT.exr: the path-traced truth.
void addRenderCommand(CLI::App& app, CommonOptions& common);

}  // namespace boxlight
