// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bake/study/kernel_study.h"

namespace boxlight {

/// The record, the kernel's boxes and its answers to the probe lights.
nlohmann::ordered_json kernelToJson(const KernelStudy& study);
/// The same as lines and tables for a terminal.
std::string kernelToText(const KernelStudy& study);

}  // namespace boxlight
