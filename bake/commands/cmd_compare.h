// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/cli.h"

namespace boxlight {

/// `ptbake compare IMAGE REFERENCE [--json] [--diff FILE.png] [--fail E]`: how far a picture is from its
/// reference, on stdout; ExitCode::difference if the RMSE is above E.
void addCompareCommand(CLI::App& app, CommonOptions& common);

}  // namespace boxlight
