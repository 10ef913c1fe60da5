// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/cli.h"

namespace boxlight {

/// ptbake bake SCENE -o OUT.ptb: the pipeline.
void addBakeCommand(CLI::App& app, CommonOptions& common);

}  // namespace boxlight
