// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "common/asset/asset.h"

namespace boxlight {

/// Which terms beyond the metallic-roughness core the materials of an asset use, under the names of glTF, and
/// how many materials use each.
std::map<std::string, uint32_t> materialTerms(const asset::Asset& asset);

}  // namespace boxlight
