// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/cli.h"

namespace boxlight {

/// `ptbake inspect ASSET [--json]`: what an asset holds, and what its bytes are spent on.
void addInspectCommand(CLI::App& app, CommonOptions& common);

}  // namespace boxlight
