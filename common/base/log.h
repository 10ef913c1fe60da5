// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <spdlog/spdlog.h>

namespace boxlight {

/// Messages go to stderr; stdout carries only what was asked for. `verbosity` -1 = errors only, 0 = info, 1 =
/// debug.
void startLog(const char* program, int verbosity);

/// The program's log: log().info("..."), log().warn("...").
spdlog::logger& log();

}  // namespace boxlight
