// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <filesystem>
#include <functional>
#include <vector>

#include "common/asset/asset_reader.h"

namespace boxlight::asset {

using Bytes = std::vector<std::byte>;

/// Changes a valid .ptb behind the writer's back and makes every hash right again, so that nothing but the
/// check in question stands between the reader and the value.
class Surgeon {
 public:
  explicit Surgeon(Bytes file);

  FileHeader header;
  std::vector<ChunkEntry> table;
  bool seal = true;  ///< false: leave fileSize and headHash of `header` as they are

  ChunkEntry& entry(uint32_t type);
  Bytes chunk(uint32_t type) const;  ///< decoded
  void setChunk(uint32_t type, const Bytes& raw);
  /// The chunk as one zstd frame, with `trailer` behind it.
  void setFrame(uint32_t type, const Bytes& raw, const Bytes& trailer);
  void addChunk(uint32_t type, const Bytes& raw);
  void removeChunk(uint32_t type);

  /// Edits entry `index` of a chunk that is an array of T.
  template <class T>
  void edit(uint32_t type, size_t index, const std::function<void(T&)>& change) {
    Bytes raw = chunk(type);
    T value;
    std::memcpy(&value, &raw.at(index * sizeof(T)), sizeof(T));
    change(value);
    std::memcpy(&raw.at(index * sizeof(T)), &value, sizeof(T));
    setChunk(type, raw);
  }
  /// Edits one box of the page at `index` of the page index.
  void editBox(size_t index, size_t box, const std::function<void(PackedBox&)>& change);
  /// Stores all pages anew.
  void setPageCodec(Codec codec);

  void write(const std::filesystem::path& path) const;

 private:
  uint32_t slotsOf(size_t page) const;  ///< boxes of each of its kernels
  Codec pageCodec() const { return const_cast<Surgeon*>(this)->entry(chunk::kPages).codec; }
  std::vector<PackedBox> decodePage(size_t index, std::span<const std::byte> stored, size_t rawSize) const;
  PageEntry addPage(Bytes& pages, size_t index, std::span<const PackedBox> boxes) const;
  uint64_t append(std::span<const std::byte> stored);

  Bytes body_;  ///< the file from `bodyStart_` on: what was there, then what was added
  uint64_t bodyStart_;
};

/// xxh64 over everything a reader gives, all pages included. Throws what the reader throws.
uint64_t contentHash(const std::filesystem::path& path);

/// A file in the test's own temporary folder, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile();
  ~TemporaryFile();
  const std::filesystem::path path;
};

}  // namespace boxlight::asset
