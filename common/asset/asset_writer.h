// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "common/asset/asset.h"

namespace boxlight::asset {

/// Returns the raw boxes of one page: popcount(mask) * boxesPerKernel of them, kernels in record order.
using PageSource = std::function<std::span<const PackedBox>(uint32_t stream, uint32_t tile)>;

/// Writes `asset` and its pages to a temporary file beside `path`, syncs it and renames it over `path`. Pages
/// are asked for in stream-major order; those with an empty mask are not asked for. The same input gives the
/// same bytes. Errors: ExitCode::io, naming the path.
void writeAsset(const std::filesystem::path& path, const Asset& asset, const PageSource& page);

}  // namespace boxlight::asset
