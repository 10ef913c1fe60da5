// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/app/view_options.h"

namespace boxlight::gpu {

/// `ptview --list-devices`: one line a device on stdout, or JSON.
void printDevices(bool json);

/// `ptview --list-keys`: the window's keys as a Markdown table.
void printKeys();

/// `ptview ASSET --headless`: reads, renders, writes. Errors: those of the readers and writers;
/// ExitCode::runtime from the device.
void renderHeadless(const ViewOptions& options);

}  // namespace boxlight::gpu
