// SPDX-License-Identifier: Apache-2.0
#include "common/asset/chunk_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <numeric>

#include "common/asset/frame_codec.h"
#include "common/base/file.h"

namespace boxlight::asset {
namespace {

constexpr uint32_t kHead = 0;

constexpr std::array kRequired = {
    chunk::kProvenance,  chunk::kInfo,      chunk::kVertices, chunk::kTriangles, chunk::kMaterials,
    chunk::kTextures,    chunk::kTexels,    chunk::kAtlas,    chunk::kRecords,   chunk::kTiles,
    chunk::kStreamMasks, chunk::kPageIndex, chunk::kPages};

constexpr std::array kOptionalTables = {chunk::kMaterialExtensions, chunk::kTextureTransforms,
                                        chunk::kVisibilityMaps,     chunk::kCellSphere,
                                        chunk::kCoarseViews,        chunk::kAtlasLevels};

/// May a reader that does not know the type do without it?
bool isSkippable(uint32_t type) { return (type & 0xFF) >= 'a' && (type & 0xFF) <= 'z'; }

[[noreturn]] void failIo(const std::filesystem::path& path, const char* reason) {
  fail(ExitCode::io, "{}: cannot read: {}", path.string(), reason);
}

template <class T>
std::span<std::byte> bytesOf(T& value) {
  return std::as_writable_bytes(std::span(&value, 1));
}

}  // namespace

const char* schemeName(Scheme scheme) {
  return scheme == Scheme::cells ? "cells" : scheme == Scheme::split ? "split" : "sketch";
}

bool isKnownChunk(uint32_t type) {
  return std::find(kRequired.begin(), kRequired.end(), type) != kRequired.end() || isOptionalTable(type);
}

bool isOptionalTable(uint32_t type) {
  return std::find(kOptionalTables.begin(), kOptionalTables.end(), type) != kOptionalTables.end();
}

ChunkFile::ChunkFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) failIo(path_, std::strerror(errno));
  struct stat status {};
  const bool known = ::fstat(descriptor_, &status) == 0;
  if (known && S_ISREG(status.st_mode)) {
    size_ = uint64_t(status.st_size);
    return;
  }
  const int reason = errno;
  ::close(descriptor_);
  failIo(path_, known ? "not a regular file" : std::strerror(reason));
}

ChunkFile::~ChunkFile() { ::close(descriptor_); }

void ChunkFile::readAt(uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), off_t(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failIo(path_, std::strerror(errno));
    if (count == 0) failIo(path_, "it became shorter while it was read");
    offset += uint64_t(count);
    bytes = bytes.subspan(size_t(count));
  }
}

bool ChunkFile::readHead(const Reporter& report) {
  if (!readHeader(report) || !readTable(report)) return false;
  for (const ChunkEntry& entry : chunks_) sound_.push_back(checkEntry(entry, report));
  dropOverlapping(report);
  checkSet(report);
  return true;
}

bool ChunkFile::readHeader(const Reporter& report) {
  using enum FindingCode;
  if (size_ < sizeof header_) {
    report(tooShort, kHead, "", "{} bytes, the header alone has {}", size_, sizeof header_);
    return false;
  }
  readAt(0, bytesOf(header_));
  if (std::memcmp(header_.magic, kMagic, sizeof kMagic) != 0) {
    report(magic, kHead, "magic", "not the signature of a .ptb file");
    return false;
  }
  if (header_.majorVersion != kMajorVersion) {
    report(majorVersion, kHead, "version", "the file is version {}.{}, this program reads version {}.x",
           header_.majorVersion, header_.minorVersion, kMajorVersion);
    return false;
  }
  if (header_.minorVersion > kMinorVersion)
    report(newerMinor, kHead, "version", "the file is version {}.{}, this program knows {}.{}",
           header_.majorVersion, header_.minorVersion, kMajorVersion, kMinorVersion);
  if (header_.fileSize != size_)
    report(fileSize, kHead, "file size", "written with {} bytes, but has {}", header_.fileSize, size_);
  if (header_.reserved != 0) report(reserved, kHead, "reserved", "{:#x} instead of 0", header_.reserved);
  return true;
}

bool ChunkFile::readTable(const Reporter& report) {
  using enum FindingCode;
  const uint32_t count = header_.chunkCount;
  if (count > kMaxChunks || size_ - sizeof header_ < count * sizeof(ChunkEntry)) {
    report(chunkTable, kHead, "chunk table", "{} chunks do not fit {} bytes, or the limit of {}", count,
           size_, kMaxChunks);
    return false;
  }
  std::vector<std::byte> head(offsetof(FileHeader, headHash) + count * sizeof(ChunkEntry));
  const auto table = std::span(head).subspan(offsetof(FileHeader, headHash));
  readAt(0, std::span(head).first(offsetof(FileHeader, headHash)));
  readAt(sizeof header_, table);
  if (const uint64_t hash = xxh64(head); hash != header_.headHash)
    report(headHash, kHead, "chunk table", "hash {:016x}, recorded {:016x}", hash, header_.headHash);
  if (header_.scheme < Scheme::sketch || header_.scheme > Scheme::cells) {
    report(scheme, kHead, "scheme",
           "transport scheme {}, this program knows {} (sketch), {} (split) and {} (cells)",
           uint32_t(header_.scheme), uint32_t(Scheme::sketch), uint32_t(Scheme::split),
           uint32_t(Scheme::cells));
    return false;
  }
  chunks_.resize(count);
  std::copy(table.begin(), table.end(), std::as_writable_bytes(std::span(chunks_)).begin());
  return true;
}

bool ChunkFile::checkEntry(const ChunkEntry& entry, const Reporter& report) const {
  using enum FindingCode;
  const uint64_t headSize = sizeof header_ + chunks_.size() * sizeof(ChunkEntry);
  if (entry.offset % 16 != 0 || entry.offset < headSize || entry.offset > size_ ||
      size_ - entry.offset < entry.storedSize) {
    report(chunkRange, entry.type, "", "offset {}, {} bytes, in a file of {} with a head of {}", entry.offset,
           entry.storedSize, size_, headSize);
    return false;
  }
  if (!isKnownChunk(entry.type)) return true;
  const bool paged = isPaged(entry.codec);
  if (paged != (entry.type == chunk::kPages) || uint32_t(entry.codec) > uint32_t(Codec::planes)) {
    report(chunkCodec, entry.type, "", "codec {}", uint32_t(entry.codec));
    return false;
  }
  const uint64_t expansion =
      entry.storedSize > UINT64_MAX / kMaxExpansion ? UINT64_MAX : entry.storedSize * kMaxExpansion;
  if (!paged && (entry.codec == Codec::none ? entry.rawSize != entry.storedSize
                                            : entry.rawSize > std::max(kFreeExpansion, expansion))) {
    report(chunkSize, entry.type, "", "{} bytes from {} stored ones with codec {}", entry.rawSize,
           entry.storedSize, uint32_t(entry.codec));
    return false;
  }
  return true;
}

void ChunkFile::dropOverlapping(const Reporter& report) {
  std::vector<size_t> order(chunks_.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::erase_if(order, [&](size_t i) { return !sound_[i] || chunks_[i].storedSize == 0; });
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return chunks_[a].offset < chunks_[b].offset; });
  const ChunkEntry* before = nullptr;
  for (const size_t i : order) {
    const ChunkEntry& entry = chunks_[i];
    if (before && entry.offset - before->offset < before->storedSize) {
      report(FindingCode::chunkOverlap, entry.type, "", "begins {} bytes into {}",
             entry.offset - before->offset, Reporter::chunkName(before->type));
      sound_[i] = false;
    } else {
      before = &entry;
    }
  }
}

void ChunkFile::checkSet(const Reporter& report) const {
  using enum FindingCode;
  for (size_t i = 0; i < chunks_.size(); ++i) {
    const uint32_t type = chunks_[i].type;
    const auto same = [&](const ChunkEntry& other) { return other.type == type; };
    const bool again = std::any_of(chunks_.begin(), chunks_.begin() + std::ptrdiff_t(i), same);
    if (again && isKnownChunk(type))
      report(chunkDuplicate, type, "", "chunk {} of the table has the same type as an earlier one", i);
    if (isKnownChunk(type)) continue;
    if (isSkippable(type))
      report(chunkSkipped, type, "", "{} bytes are skipped", chunks_[i].storedSize);
    else
      report(chunkUnknown, type, "", "this program (format {}.{}) does not know it", kMajorVersion,
             kMinorVersion);
  }
  for (const uint32_t type : kRequired)
    if (!names(type)) report(chunkMissing, type, "", "not in the chunk table");
}

const ChunkEntry* ChunkFile::find(uint32_t type) const {
  for (size_t i = 0; i < chunks_.size(); ++i)
    if (sound_[i] && chunks_[i].type == type) return &chunks_[i];
  return nullptr;
}

bool ChunkFile::names(uint32_t type) const {
  return std::any_of(chunks_.begin(), chunks_.end(),
                     [&](const ChunkEntry& entry) { return entry.type == type; });
}

std::optional<std::vector<std::byte>> ChunkFile::readStored(const ChunkEntry& entry,
                                                            const Reporter& report) const {
  std::vector<std::byte> stored(entry.storedSize);
  readAt(entry.offset, stored);
  const uint64_t hash = xxh64(stored);
  if (hash == entry.hash) return stored;
  report(FindingCode::chunkHash, entry.type, "", "hash {:016x}, recorded {:016x}", hash, entry.hash);
  return std::nullopt;
}

bool ChunkFile::read(const ChunkEntry& entry, std::span<std::byte> raw, const Reporter& report) const {
  const auto stored = readStored(entry, report);
  if (!stored) return false;
  if (entry.codec == Codec::none) {
    std::copy(stored->begin(), stored->end(), raw.begin());
    return true;
  }
  if (decompressFrame(*stored, raw)) return true;
  report(FindingCode::chunkFrame, entry.type, "", "not one zstd frame of {} bytes", raw.size());
  return false;
}

}  // namespace boxlight::asset
