// SPDX-License-Identifier: Apache-2.0
#include "common/asset/asset_load.h"

#include <stdexcept>

namespace boxlight::asset {
namespace {

template <class T>
bool readTable(const ChunkFile& file, uint32_t type, std::vector<T>& table, const Reporter& report) {
  const ChunkEntry* entry = file.find(type);
  if (!entry) return isOptionalTable(type) && !file.names(type);
  if (entry->rawSize % sizeof(T) != 0) {
    report(FindingCode::chunkSize, type, "", "{} bytes are not a whole number of {}-byte entries",
           entry->rawSize, sizeof(T));
    return false;
  }
  table.resize(entry->rawSize / sizeof(T));
  if (file.read(*entry, std::as_writable_bytes(std::span(table)), report)) return true;
  table.clear();
  return false;
}

bool readInfo(const ChunkFile& file, Info& info, const Reporter& report) {
  std::vector<Info> table;
  if (!readTable(file, chunk::kInfo, table, report)) return false;
  if (table.size() != 1) {
    report(FindingCode::chunkSize, chunk::kInfo, "", "{} entries instead of one", table.size());
    return false;
  }
  info = table[0];
  return true;
}

// Depth is bounded because printing and destroying a document recurse.
nlohmann::ordered_json parseBounded(const std::vector<char>& text) {
  const auto limitDepth = [](int depth, auto, auto&) {
    if (depth > int(kMaxProvenanceDepth)) throw std::length_error("nested too deeply");
    return true;
  };
  return nlohmann::ordered_json::parse(text.begin(), text.end(), limitDepth);
}

bool readProvenance(const ChunkFile& file, nlohmann::ordered_json& provenance, const Reporter& report) {
  const auto refuse = [&](const std::string& why) {
    report(FindingCode::provenance, chunk::kProvenance, "", "{}", why);
    return false;
  };
  const ChunkEntry* entry = file.find(chunk::kProvenance);
  if (entry && entry->rawSize > kMaxProvenanceSize) return refuse(fmt::format("{} bytes", entry->rawSize));
  std::vector<char> text;
  if (!readTable(file, chunk::kProvenance, text, report)) return false;
  nlohmann::ordered_json document;
  try {
    document = parseBounded(text);
  } catch (const nlohmann::json::exception& error) {
    return refuse(error.what());
  } catch (const std::length_error& error) {
    return refuse(error.what());
  }
  if (!document.is_object()) return refuse("not a JSON object");
  provenance = std::move(document);
  return true;
}

}  // namespace

LoadedAsset loadAsset(const ChunkFile& file, const Reporter& report) {
  LoadedAsset loaded;
  const auto note = [&](uint32_t type, bool isRead) {
    if (isRead) loaded.present.add(type);
  };
  loaded.asset.scheme = file.header().scheme;
  note(chunk::kProvenance, readProvenance(file, loaded.asset.provenance, report));
  note(chunk::kInfo, readInfo(file, loaded.asset.info, report));
  forEachTable(loaded.asset,
               [&](uint32_t type, auto& table) { note(type, readTable(file, type, table, report)); });
  note(chunk::kPageIndex, readTable(file, chunk::kPageIndex, loaded.pageIndex, report));
  if (file.find(chunk::kPages)) loaded.present.add(chunk::kPages);
  return loaded;
}

}  // namespace boxlight::asset
