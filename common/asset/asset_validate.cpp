// SPDX-License-Identifier: Apache-2.0
#include "common/asset/asset_validate.h"

#include "common/asset/asset_checks.h"
#include "common/asset/page_read.h"

namespace boxlight::asset {
namespace {

/// Chunks that this version does not know are not decoded, but their bytes can be verified.
void verifySkippedChunks(const ChunkFile& file, const Reporter& report) {
  for (const ChunkEntry& entry : file.chunks())
    if (!isKnownChunk(entry.type) && (entry.codec == Codec::none || entry.codec == Codec::zstd) &&
        file.find(entry.type) == &entry)
      file.readStored(entry, report);
}

void checkPages(const ChunkFile& file, const LoadedAsset& loaded, const Reporter& report) {
  const Asset& asset = loaded.asset;
  const uint64_t pagesSize = file.find(chunk::kPages)->storedSize;
  EmittedSlots emitted(asset);
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile)
      if (pageIsSound(loaded, stream, tile, pagesSize))
        emitted.check(stream, tile, readPage(file, loaded, stream, tile, report), report);
}

}  // namespace

uint64_t Validation::total(Severity severity) const {
  uint64_t sum = 0;
  for (const auto& [code, number] : count)
    if (findingKind(code).severity == severity) sum += number;
  return sum;
}

ExitCode Validation::exitCode() const {
  ExitCode result = ExitCode::ok;
  for (const auto& [code, number] : count) {
    const FindingKind& kind = findingKind(code);
    if (kind.severity != Severity::error) continue;
    if (kind.exitCode == ExitCode::invalidInput) return kind.exitCode;
    result = kind.exitCode;
  }
  return result;
}

Validation validateAsset(const std::filesystem::path& path) {
  Validation validation;
  const Reporter report([&](Finding finding) {
    if (++validation.count[finding.kind->code] <= kShownPerCode)
      validation.findings.push_back(std::move(finding));
  });
  ChunkFile file(path);
  if (!file.readHead(report)) return validation;
  const LoadedAsset loaded = loadAsset(file, report);
  verifySkippedChunks(file, report);
  checkCounts(loaded, report);
  checkTables(loaded.asset, loaded.present, report);
  if (!pagesCanBeFound(loaded)) return validation;
  checkPageIndex(loaded, file.find(chunk::kPages)->storedSize, report);
  checkPages(file, loaded, report);
  return validation;
}

}  // namespace boxlight::asset
