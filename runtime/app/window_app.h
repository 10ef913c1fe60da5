// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/app/view_options.h"

namespace boxlight::gpu {

/// `ptview ASSET`: a window until it is closed. Errors: those of the readers for what the command line names
/// (later files only leave a message in the window); ExitCode::runtime from display and device.
void runWindow(const ViewOptions& options);

}  // namespace boxlight::gpu
