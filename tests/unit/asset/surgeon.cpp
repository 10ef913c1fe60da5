// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/asset/surgeon.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "common/asset/asset_load.h"
#include "common/asset/page_codec.h"
#include "common/base/file.h"

namespace boxlight::asset {
namespace {

// Room for more chunks in the table than a valid file has.
constexpr uint64_t kHeadRoom = 16384;

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

}  // namespace

Surgeon::Surgeon(Bytes file) : bodyStart_(kHeadRoom) {
  std::memcpy(&header, file.data(), sizeof header);
  table.resize(header.chunkCount);
  const uint64_t oldStart = sizeof header + table.size() * sizeof(ChunkEntry);
  std::memcpy(table.data(), &file[sizeof header], table.size() * sizeof(ChunkEntry));
  for (ChunkEntry& chunkEntry : table) chunkEntry.offset += kHeadRoom - oldStart / 16 * 16;
  body_.assign(file.begin() + std::ptrdiff_t(oldStart / 16 * 16), file.end());
}

ChunkEntry& Surgeon::entry(uint32_t type) {
  return *std::find_if(table.begin(), table.end(), [&](const ChunkEntry& e) { return e.type == type; });
}

Bytes Surgeon::chunk(uint32_t type) const {
  const ChunkEntry& e = const_cast<Surgeon*>(this)->entry(type);
  const auto stored = std::span(body_).subspan(e.offset - bodyStart_, e.storedSize);
  Bytes raw(e.rawSize);
  if (e.codec != Codec::zstd) return Bytes(stored.begin(), stored.end());
  EXPECT_TRUE(decompressFrame(stored, raw));
  return raw;
}

uint64_t Surgeon::append(std::span<const std::byte> stored) {
  body_.resize((body_.size() + 15) / 16 * 16);
  const uint64_t offset = bodyStart_ + body_.size();
  body_.insert(body_.end(), stored.begin(), stored.end());
  return offset;
}

void Surgeon::setChunk(uint32_t type, const Bytes& raw) {
  const uint64_t offset = append(raw);
  const Codec codec = type == chunk::kPages ? entry(type).codec : Codec::none;
  entry(type) = {type, codec, offset, raw.size(), raw.size(), type == chunk::kPages ? 0 : xxh64(raw)};
}

void Surgeon::setFrame(uint32_t type, const Bytes& raw, const Bytes& trailer) {
  FrameCompressor compressor;
  const auto frame = compressor.compress(raw);
  Bytes stored(frame.begin(), frame.end());
  stored.insert(stored.end(), trailer.begin(), trailer.end());
  const uint64_t offset = append(stored);
  entry(type) = {type, Codec::zstd, offset, stored.size(), raw.size(), xxh64(stored)};
}

void Surgeon::addChunk(uint32_t type, const Bytes& raw) {
  const uint64_t offset = append(raw);
  table.push_back({type, Codec::none, offset, raw.size(), raw.size(), xxh64(raw)});
}

void Surgeon::removeChunk(uint32_t type) {
  std::erase_if(table, [&](const ChunkEntry& e) { return e.type == type; });
}

uint32_t Surgeon::slotsOf(size_t page) const {
  const Bytes info = chunk(chunk::kInfo), tiles = chunk(chunk::kTiles);
  Info head;
  std::memcpy(&head, info.data(), sizeof head);
  const size_t count = tiles.size() / sizeof(Tile);
  Tile tile;
  std::memcpy(&tile, &tiles[page % count * sizeof tile], sizeof tile);
  return page / count == head.viewCount ? tile.diffuseBoxes : tile.glossyBoxes;
}

std::vector<PackedBox> Surgeon::decodePage(size_t index, std::span<const std::byte> stored,
                                           size_t rawSize) const {
  std::vector<PackedBox> boxes(rawSize / sizeof(PackedBox));
  Bytes raw(rawSize);
  EXPECT_TRUE(decompressFrame(stored, raw));
  if (pageCodec() == Codec::planes)
    planesToBoxes(raw, slotsOf(index), boxes);
  else
    std::memcpy(boxes.data(), raw.data(), rawSize);
  return boxes;
}

PageEntry Surgeon::addPage(Bytes& pages, size_t index, std::span<const PackedBox> boxes) const {
  FrameCompressor compressor;
  const auto frame = pageCodec() == Codec::planes ? compressPage(compressor, boxes, slotsOf(index))
                                                  : compressor.compress(std::as_bytes(boxes));
  pages.insert(pages.end(), frame.begin(), frame.end());
  return {pages.size() - frame.size(), uint32_t(frame.size()), uint32_t(boxes.size_bytes()), xxh64(frame)};
}

void Surgeon::editBox(size_t index, size_t box, const std::function<void(PackedBox&)>& change) {
  Bytes pages = chunk(chunk::kPages);
  edit<PageEntry>(chunk::kPageIndex, index, [&](PageEntry& page) {
    auto boxes = decodePage(index, std::span(pages).subspan(page.offset, page.storedSize), page.rawSize);
    change(boxes.at(box));
    page = addPage(pages, index, boxes);
  });
  setChunk(chunk::kPages, pages);
}

void Surgeon::setPageCodec(Codec codec) {
  const Bytes old = chunk(chunk::kPages);
  std::vector<std::vector<PackedBox>> decoded;
  const size_t count = chunk(chunk::kPageIndex).size() / sizeof(PageEntry);
  for (size_t i = 0; i < count; ++i)
    edit<PageEntry>(chunk::kPageIndex, i, [&](PageEntry& page) {
      const auto stored = std::span(old).subspan(page.offset, page.storedSize);
      decoded.push_back(stored.empty() ? std::vector<PackedBox>() : decodePage(i, stored, page.rawSize));
    });
  entry(chunk::kPages).codec = codec;
  Bytes pages;
  for (size_t i = 0; i < count; ++i)
    if (!decoded[i].empty())
      edit<PageEntry>(chunk::kPageIndex, i, [&](PageEntry& page) { page = addPage(pages, i, decoded[i]); });
  setChunk(chunk::kPages, pages);
}

void Surgeon::write(const std::filesystem::path& path) const {
  FileHeader sealed = header;
  Bytes head(offsetof(FileHeader, headHash));
  if (seal) {
    sealed.chunkCount = uint32_t(table.size());
    sealed.fileSize = bodyStart_ + body_.size();
    std::memcpy(head.data(), &sealed, head.size());
    head.insert(head.end(), bytesOf(table).begin(), bytesOf(table).end());
    sealed.headHash = xxh64(head);
  }
  Bytes file(bodyStart_);
  std::memcpy(file.data(), &sealed, sizeof sealed);
  std::copy(bytesOf(table).begin(), bytesOf(table).end(), file.begin() + sizeof sealed);
  file.insert(file.end(), body_.begin(), body_.end());
  AtomicFile out(path);
  out.write(file);
  out.commit();
}

uint64_t contentHash(const std::filesystem::path& path) {
  const AssetReader reader(path);
  const Asset& asset = reader.asset();
  uint64_t hash = xxh64(std::as_bytes(std::span(&asset.info, 1)), uint64_t(asset.scheme));
  const std::string provenance = asset.provenance.dump();
  hash = xxh64(std::as_bytes(std::span(provenance)), hash);
  forEachTable(asset, [&](uint32_t type, const auto& values) {
    if (!values.empty() || !isOptionalTable(type)) hash = xxh64(bytesOf(values), hash);
  });
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile)
      hash = xxh64(bytesOf(reader.page(stream, tile)), hash);
  return hash;
}

TemporaryFile::TemporaryFile()
    : path(std::filesystem::path(::testing::TempDir()) /
           fmt::format("asset_test.{}.{}.ptb", ::getpid(), static_cast<const void*>(this))) {}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

}  // namespace boxlight::asset
