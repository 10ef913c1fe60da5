// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "common/asset/asset_format.h"
#include "common/asset/finding.h"

namespace boxlight::asset {

/// Does version 1 have a chunk of this type?
bool isKnownChunk(uint32_t type);
/// One of those that a file has only if the table has entries?
bool isOptionalTable(uint32_t type);

/// The container of a .ptb: header, chunk table and the stored bytes of each chunk, all range-checked. It
/// knows which chunks version 1 has, not what is in them. Errors: ExitCode::io is thrown; everything else
/// goes to the Reporter given.
class ChunkFile {
 public:
  explicit ChunkFile(std::filesystem::path path);
  ~ChunkFile();
  ChunkFile(const ChunkFile&) = delete;
  ChunkFile& operator=(const ChunkFile&) = delete;

  /// Reads and checks header and chunk table. False if the rest of the file cannot be made sense of.
  bool readHead(const Reporter& report);

  const std::filesystem::path& path() const { return path_; }
  uint64_t size() const { return size_; }
  const FileHeader& header() const { return header_; }
  const std::vector<ChunkEntry>& chunks() const { return chunks_; }
  /// The chunk of this type whose table entry is sound, or null.
  const ChunkEntry* find(uint32_t type) const;
  /// Is there an entry of this type, sound or not?
  bool names(uint32_t type) const;

  /// Reads, verifies and decodes a chunk into `raw`, of entry.rawSize bytes. False if it is damaged. Not
  /// for pages.
  bool read(const ChunkEntry& entry, std::span<std::byte> raw, const Reporter& report) const;
  /// The stored bytes, verified but not decoded.
  std::optional<std::vector<std::byte>> readStored(const ChunkEntry& entry, const Reporter& report) const;
  /// bytes.size() bytes at `offset`, which lie inside the file. Safe to call from several threads.
  void readAt(uint64_t offset, std::span<std::byte> bytes) const;

 private:
  bool readHeader(const Reporter& report);
  bool readTable(const Reporter& report);
  bool checkEntry(const ChunkEntry& entry, const Reporter& report) const;
  void dropOverlapping(const Reporter& report);
  void checkSet(const Reporter& report) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  uint64_t size_ = 0;
  FileHeader header_{};
  std::vector<ChunkEntry> chunks_;
  std::vector<bool> sound_;
};

}  // namespace boxlight::asset
