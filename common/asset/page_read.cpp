// SPDX-License-Identifier: Apache-2.0
#include "common/asset/page_read.h"

#include "common/asset/asset_checks.h"
#include "common/asset/page_codec.h"
#include "common/base/file.h"

namespace boxlight::asset {

std::span<const std::byte> readStoredPage(const ChunkFile& file, const LoadedAsset& loaded, uint32_t stream,
                                          uint32_t tile, const Reporter& report) {
  const PageEntry& entry = loaded.pageIndex[size_t(stream) * loaded.asset.tiles.size() + tile];
  if (entry.storedSize == 0) return {};
  thread_local std::vector<std::byte> stored;
  stored.resize(entry.storedSize);
  file.readAt(file.find(chunk::kPages)->offset + entry.offset, stored);
  if (const uint64_t hash = xxh64(stored); hash != entry.hash) {
    report(FindingCode::pageHash, chunk::kPages, pagePlace(loaded.asset, stream, tile),
           "hash {:016x}, recorded {:016x}", hash, entry.hash);
    return {};
  }
  return stored;
}

namespace {

bool decodePage(Codec codec, std::span<const std::byte> stored, uint32_t slots, std::span<PackedBox> boxes) {
  if (codec == Codec::pages) return decompressFrame(stored, std::as_writable_bytes(boxes));
  thread_local std::vector<std::byte> planes;
  planes.resize(boxes.size_bytes());
  if (!decompressFrame(stored, planes)) return false;
  planesToBoxes(planes, slots, boxes);
  return true;
}

}  // namespace

std::vector<PackedBox> readPage(const ChunkFile& file, const LoadedAsset& loaded, uint32_t stream,
                                uint32_t tile, const Reporter& report) {
  const Asset& asset = loaded.asset;
  const std::span<const std::byte> stored = readStoredPage(file, loaded, stream, tile, report);
  if (stored.empty()) return {};
  const std::string place = pagePlace(asset, stream, tile);
  std::vector<PackedBox> boxes(pageBoxCount(asset, stream, tile));
  if (!decodePage(file.find(chunk::kPages)->codec, stored, asset.boxesPerKernel(stream, tile), boxes)) {
    report(FindingCode::pageFrame, chunk::kPages, place, "not one zstd frame of {} bytes",
           boxes.size() * sizeof(PackedBox));
    return {};
  }
  checkBoxes(boxes, asset.boxesPerKernel(stream, tile), place, report);
  checkSlotKinds(asset, stream, tile, boxes, report);
  return boxes;
}

}  // namespace boxlight::asset
