// SPDX-License-Identifier: Apache-2.0
#include "common/asset/asset_reader.h"

#include <cassert>
#include <optional>

#include "common/asset/asset_checks.h"
#include "common/asset/page_read.h"

namespace boxlight::asset {

struct AssetReader::Impl {
  explicit Impl(const std::filesystem::path& path) : file(path), report(throwingReporter(path.string())) {
    file.readHead(report);
    loaded = loadAsset(file, report);
    checkCounts(loaded, report);
    checkTables(loaded.asset, loaded.present, report);
    assert(pagesCanBeFound(loaded));
    checkPageIndex(loaded, file.find(chunk::kPages)->storedSize, report);
    emitted.emplace(loaded.asset);
  }

  ChunkFile file;
  Reporter report;
  LoadedAsset loaded;
  std::optional<EmittedSlots> emitted;
};

AssetReader::AssetReader(const std::filesystem::path& path) : impl_(std::make_unique<Impl>(path)) {}
AssetReader::~AssetReader() = default;
AssetReader::AssetReader(AssetReader&&) noexcept = default;

const Asset& AssetReader::asset() const { return impl_->loaded.asset; }
const std::filesystem::path& AssetReader::path() const { return impl_->file.path(); }
const FileHeader& AssetReader::header() const { return impl_->file.header(); }
const std::vector<ChunkEntry>& AssetReader::chunks() const { return impl_->file.chunks(); }

const PageEntry& AssetReader::pageEntry(uint32_t stream, uint32_t tile) const {
  assert(stream < asset().streamCount() && tile < asset().tiles.size());
  return impl_->loaded.pageIndex[size_t(stream) * asset().tiles.size() + tile];
}

void AssetReader::verifyPages() const {
  for (uint32_t stream = 0; stream < asset().streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset().tiles.size(); ++tile)
      readStoredPage(impl_->file, impl_->loaded, stream, tile, impl_->report);
}

std::vector<PackedBox> AssetReader::page(uint32_t stream, uint32_t tile) const {
  assert(stream < asset().streamCount() && tile < asset().tiles.size());
  std::vector<PackedBox> boxes = readPage(impl_->file, impl_->loaded, stream, tile, impl_->report);
  impl_->emitted->check(stream, tile, boxes, impl_->report);
  return boxes;
}

}  // namespace boxlight::asset
