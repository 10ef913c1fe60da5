// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "common/asset/asset_load.h"

namespace boxlight::asset {

/// The stored bytes of a page, verified against its hash; valid until this thread's next call. Empty if the
/// page is absent, or damaged, which goes to `report`. Safe to call from several threads.
std::span<const std::byte> readStoredPage(const ChunkFile& file, const LoadedAsset& loaded, uint32_t stream,
                                          uint32_t tile, const Reporter& report);

/// Reads, verifies and decodes the page of one stream of one tile, whose index entry checkPageIndex has
/// passed. Damage goes to `report`; what comes back then is empty. Safe to call from several threads.
std::vector<PackedBox> readPage(const ChunkFile& file, const LoadedAsset& loaded, uint32_t stream,
                                uint32_t tile, const Reporter& report);

}  // namespace boxlight::asset
