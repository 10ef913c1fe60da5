// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/cli.h"

namespace boxlight {

/// `ptbake validate ASSET [--json]`: everything that is wrong with an asset, as numbered findings. Ends with
/// ExitCode::invalidInput (or unsupported) if one of them is an error.
void addValidateCommand(CLI::App& app, CommonOptions& common);

}  // namespace boxlight
