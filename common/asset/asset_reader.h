// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "common/asset/asset.h"

namespace boxlight::asset {

/// An open .ptb: everything but the pages is read and checked by the constructor; pages are read one by one.
/// Every offset, count and index is range-checked before use, so a hostile file ends in an Error and nothing
/// else. Errors: ExitCode::io if it cannot be read, ExitCode::invalidInput if it is damaged,
/// ExitCode::unsupported for another major version or scheme; each message names the file, the chunk and the
/// remedy.
class AssetReader {
 public:
  explicit AssetReader(const std::filesystem::path& path);
  ~AssetReader();
  AssetReader(AssetReader&&) noexcept;

  const Asset& asset() const;
  const std::filesystem::path& path() const;
  const FileHeader& header() const;
  const std::vector<ChunkEntry>& chunks() const;
  const PageEntry& pageEntry(uint32_t stream, uint32_t tile) const;

  /// Reads every page and checks its hash, so that damage is found even where nobody looks. Errors as the
  /// constructor's.
  void verifyPages() const;

  /// Reads, verifies and decodes one page; empty if its mask is empty. Safe to call from several threads.
  std::vector<PackedBox> page(uint32_t stream, uint32_t tile) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxlight::asset
