// SPDX-License-Identifier: Apache-2.0
#include "common/asset/asset_writer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include "common/asset/asset_checks.h"
#include "common/asset/page_codec.h"
#include "common/base/file.h"

namespace boxlight::asset {
namespace {

constexpr uint64_t kAlignment = 16;
constexpr uint32_t kChunksBesidesTables = 4;  // PROV, INFO, PAGE, PGIX

/// Appends chunks; finish() writes header and table into the room left for them at the start.
class ChunkWriter {
 public:
  ChunkWriter(const std::filesystem::path& path, uint32_t chunkCount) : file_(path), chunkCount_(chunkCount) {
    file_.write(std::vector<std::byte>(sizeof(FileHeader) + chunkCount * sizeof(ChunkEntry)));
  }

  void add(uint32_t type, std::span<const std::byte> raw) {
    const auto frame = compressor_.compress(raw);
    // Nothing smaller than it could be decoded from: see "Limits" in docs/format.md.
    const bool allowed = raw.size() <= std::max(kFreeExpansion, kMaxExpansion * frame.size());
    const bool packed = allowed && frame.size() < raw.size();
    const auto stored = packed ? frame : raw;
    align();
    table_.push_back(
        {type, packed ? Codec::zstd : Codec::none, file_.size(), stored.size(), raw.size(), xxh64(stored)});
    file_.write(stored);
  }

  void beginPages() {
    align();
    table_.push_back({chunk::kPages, Codec::planes, file_.size(), 0, 0, 0});
  }

  PageEntry addPage(std::span<const PackedBox> boxes, uint32_t slots) {
    ChunkEntry& pages = table_.back();
    assert(pages.type == chunk::kPages && !boxes.empty());
    const auto frame = compressPage(compressor_, boxes, slots);
    const PageEntry entry{pages.storedSize, uint32_t(frame.size()), uint32_t(boxes.size_bytes()),
                          xxh64(frame)};
    file_.write(frame);
    pages.storedSize += entry.storedSize;
    pages.rawSize += entry.rawSize;
    return entry;
  }

  void finish(Scheme scheme) {
    assert(table_.size() == chunkCount_);
    FileHeader header{.majorVersion = kMajorVersion,
                      .minorVersion = kMinorVersion,
                      .scheme = scheme,
                      .chunkCount = chunkCount_,
                      .fileSize = file_.size()};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    const auto table = std::as_bytes(std::span(table_));
    const auto fields = std::as_bytes(std::span(&header, 1)).first(offsetof(FileHeader, headHash));
    std::vector<std::byte> head(fields.begin(), fields.end());
    head.insert(head.end(), table.begin(), table.end());
    header.headHash = xxh64(head);
    file_.writeAt(0, std::as_bytes(std::span(&header, 1)));
    file_.writeAt(sizeof header, table);
    file_.commit();
  }

 private:
  void align() {
    const std::array<std::byte, kAlignment> zeros{};
    file_.write(std::span(zeros).first((kAlignment - file_.size() % kAlignment) % kAlignment));
  }

  AtomicFile file_;
  FrameCompressor compressor_;
  const uint32_t chunkCount_;
  std::vector<ChunkEntry> table_;
};

Info infoOf(const Asset& asset) {
  Info info = asset.info;
  info.vertexCount = uint32_t(asset.vertices.size());
  info.triangleCount = uint32_t(asset.triangles.size());
  info.materialCount = uint32_t(asset.materials.size());
  info.textureCount = uint32_t(asset.textures.size());
  info.recordCount = uint32_t(asset.records.size());
  info.tileCount = uint32_t(asset.tiles.size());
  return info;
}

/// forEachTable without the optional tables that the file need not have.
template <class F>
void forEachWrittenTable(const Asset& asset, F&& f) {
  forEachTable(asset, [&](uint32_t type, const auto& table) {
    if (!table.empty() || !isOptionalTable(type)) f(type, std::as_bytes(std::span(table)));
  });
}

ChunkSet allTables(const Asset& asset) {
  ChunkSet present;
  present.add(chunk::kInfo);
  forEachTable(asset, [&](uint32_t type, const auto&) { present.add(type); });
  return present;
}

/// What the reader would refuse is not written. It is a bug of the caller, but one that a long bake should
/// end with, not leave behind.
Reporter refusal(const std::filesystem::path& path) {
  return Reporter([name = path.string()](const Finding& finding) {
    if (finding.kind->severity == Severity::error)
      fail(ExitCode::runtime, "{}: not written, it would be invalid: {}", name, finding.message());
  });
}

std::vector<PageEntry> writePages(ChunkWriter& writer, const Asset& asset, const PageSource& page,
                                  const Reporter& report) {
  std::vector<PageEntry> index(asset.streamMasks.size());
  EmittedSlots emitted(asset);
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) {
      if (asset.mask(stream, tile) == 0) continue;
      const auto boxes = page(stream, tile);
      const std::string place = pagePlace(asset, stream, tile);
      if (const uint64_t expected = pageBoxCount(asset, stream, tile); boxes.size() != expected)
        report(FindingCode::pageSize, chunk::kPages, place, "{} boxes instead of {}", boxes.size(), expected);
      const uint32_t slots = asset.boxesPerKernel(stream, tile);
      checkBoxes(boxes, slots, place, report);
      checkSlotKinds(asset, stream, tile, boxes, report);
      emitted.check(stream, tile, boxes, report);
      index[size_t(stream) * asset.tiles.size() + tile] = writer.addPage(boxes, slots);
    }
  return index;
}

}  // namespace

void writeAsset(const std::filesystem::path& path, const Asset& asset, const PageSource& page) {
  const Reporter report = refusal(path);
  checkTables(asset, allTables(asset), report);
  const std::string provenance =
      asset.provenance.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (!asset.provenance.is_object() || provenance.size() > kMaxProvenanceSize)
    report(FindingCode::provenance, chunk::kProvenance, "", "{} bytes of {}", provenance.size(),
           asset.provenance.type_name());
  uint32_t chunkCount = kChunksBesidesTables;
  forEachWrittenTable(asset, [&](uint32_t, std::span<const std::byte>) { ++chunkCount; });
  ChunkWriter writer(path, chunkCount);
  const Info info = infoOf(asset);
  writer.add(chunk::kProvenance, std::as_bytes(std::span(provenance)));
  writer.add(chunk::kInfo, std::as_bytes(std::span(&info, 1)));
  forEachWrittenTable(asset,
                      [&](uint32_t type, std::span<const std::byte> bytes) { writer.add(type, bytes); });
  writer.beginPages();
  const std::vector<PageEntry> index = writePages(writer, asset, page, report);
  writer.add(chunk::kPageIndex, std::as_bytes(std::span(index)));
  writer.finish(asset.scheme);
}

}  // namespace boxlight::asset
