// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/asset/asset_load.h"

namespace boxlight::asset {

/// Reads, verifies and decodes the page of one stream of one tile, whose index entry checkPageIndex has
/// passed. Damage goes to `report`; what comes back then is empty. Safe to call from several threads.
std::vector<PackedBox> readPage(const ChunkFile& file, const LoadedAsset& loaded, uint32_t stream,
                                uint32_t tile, const Reporter& report);

}  // namespace boxlight::asset
