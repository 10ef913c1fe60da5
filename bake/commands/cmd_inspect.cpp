// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_inspect.h"

#include <array>
#include <bit>
#include <memory>
#include <nlohmann/json.hpp>

#include "bake/commands/material_terms.h"
#include "common/asset/asset_reader.h"
#include "common/asset/finding.h"

namespace boxlight {
namespace {

using asset::Asset;
using asset::AssetReader;
using asset::ChunkEntry;
using Json = nlohmann::ordered_json;

/// The pages of one kind of stream.
struct PageTotals {
  uint64_t pages = 0, kernels = 0, boxes = 0, stored = 0, raw = 0;
  uint64_t emitted = 0;  // kernels with emitted radiance
};

struct Summary {
  PageTotals glossy, diffuse, cells;
  uint64_t head = 0, padding = 0, coveredTexels = 0;
};

void addPage(PageTotals& totals, uint64_t kernels, uint64_t boxes, const asset::PageEntry& page) {
  totals.pages += kernels > 0;
  totals.kernels += kernels;
  totals.boxes += boxes;
  totals.stored += page.storedSize;
  totals.raw += page.rawSize;
}

PageTotals& totalsOf(Summary& summary, const Asset& asset, uint32_t stream) {
  if (stream == asset.diffuseStream()) return summary.diffuse;
  return stream < asset.diffuseStream() ? summary.glossy : summary.cells;
}

/// The kernels of a tile agree on whether they begin with emitted radiance, so that one page of each kind
/// tells.
uint64_t emittedKernels(const AssetReader& reader, uint32_t firstStream, uint32_t endStream) {
  const Asset& asset = reader.asset();
  uint64_t sum = 0;
  for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) {
    uint64_t kernels = 0;
    uint32_t some = endStream;
    for (uint32_t stream = firstStream; stream < endStream; ++stream) {
      kernels += uint64_t(std::popcount(asset.mask(stream, tile)));
      if (asset.mask(stream, tile) != 0) some = stream;
    }
    if (some != endStream && isEmission(reader.page(some, tile)[0])) sum += kernels;
  }
  return sum;
}

Summary summarise(const AssetReader& reader) {
  const Asset& asset = reader.asset();
  Summary summary;
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) {
      const auto kernels = uint64_t(std::popcount(asset.mask(stream, tile)));
      addPage(totalsOf(summary, asset, stream), kernels, kernels * asset.boxesPerKernel(stream, tile),
              reader.pageEntry(stream, tile));
    }
  summary.glossy.emitted = emittedKernels(reader, 0, asset.diffuseStream());
  summary.diffuse.emitted = emittedKernels(reader, asset.diffuseStream(), asset.firstCellStream());
  summary.cells.emitted = emittedKernels(reader, asset.firstCellStream(), asset.streamCount());
  summary.head = sizeof(asset::FileHeader) + reader.chunks().size() * sizeof(ChunkEntry);
  summary.padding = reader.header().fileSize - summary.head;
  for (const ChunkEntry& entry : reader.chunks()) summary.padding -= entry.storedSize;
  for (const asset::AtlasTexel& texel : asset.atlas)
    summary.coveredTexels += texel.front != asset::kNone || texel.back != asset::kNone;
  return summary;
}

/// Chunks that a reader skips may have any.
std::string codecName(asset::Codec codec) {
  constexpr std::array kNames = {"none", "zstd", "pages", "planes"};
  const auto number = size_t(codec);
  return number < kNames.size() ? kNames[number] : fmt::format("codec {}", number);
}

double ratio(uint64_t value, uint64_t by) { return by ? double(value) / double(by) : 0.0; }

Json pagesToJson(const PageTotals& totals, uint64_t records) {
  return {{"pages", totals.pages},
          {"kernels", totals.kernels},
          {"emittedKernels", totals.emitted},
          {"boxes", totals.boxes},
          {"stored", totals.stored},
          {"raw", totals.raw},
          {"storedPerRecord", ratio(totals.stored, records)},
          {"storedPerBox", ratio(totals.stored, totals.boxes)},
          {"kernelsPerRecord", ratio(totals.kernels, records)},
          {"boxesPerKernel", ratio(totals.boxes, totals.kernels)}};
}

Json bytesToJson(const AssetReader& reader, const Summary& summary) {
  Json chunks = Json::array();
  for (const ChunkEntry& entry : reader.chunks())
    chunks.push_back({{"type", asset::Reporter::chunkName(entry.type)},
                      {"codec", codecName(entry.codec)},
                      {"stored", entry.storedSize},
                      {"raw", entry.rawSize}});
  const uint64_t records = reader.asset().records.size();
  return {{"file", reader.header().fileSize},
          {"perRecord", ratio(reader.header().fileSize, records)},
          {"head", summary.head},
          {"padding", summary.padding},
          {"chunks", chunks},
          {"glossyPages", pagesToJson(summary.glossy, records)},
          {"diffusePages", pagesToJson(summary.diffuse, records)},
          {"cellPages", pagesToJson(summary.cells, records)}};
}

Json mapsToJson(const AssetReader& reader) {
  Json maps = {{"count", reader.asset().visibilityMaps.size()}, {"stored", 0}, {"raw", 0}};
  for (const ChunkEntry& entry : reader.chunks())
    if (entry.type == asset::chunk::kVisibilityMaps)
      maps["stored"] = entry.storedSize, maps["raw"] = entry.rawSize;
  return maps;
}

/// A sphere of directions, and for how many records it is.
template <class Predicate>
Json sphereToJson(const Asset& asset, asset::GeodesicSphere sphere, Predicate&& isFor) {
  uint64_t records = 0;
  for (uint32_t record = 0; record < asset.records.size(); ++record) records += isFor(record);
  return {{"frequency", sphere.frequency}, {"count", sphere.count}, {"records", records}};
}

Json cellsToJson(const Asset& asset) {
  return sphereToJson(asset, asset.cellSphere.empty() ? asset::GeodesicSphere{} : asset.cellSphere[0],
                      [&](uint32_t record) { return asset.hasCells(record); });
}

Json coarseViewsToJson(const Asset& asset) {
  Json spheres = Json::array();
  for (uint32_t s = 0; s < asset.coarseViews.size(); ++s)
    spheres.push_back(sphereToJson(asset, asset.coarseViews[s],
                                   [&](uint32_t record) { return asset.viewSphere(record) == s + 1; }));
  return spheres;
}

/// Level by level of the atlas.
std::vector<uint64_t> recordsOfLevels(const Asset& asset) {
  std::vector<uint64_t> records(asset.levelCount());
  for (const asset::TexelRecord& record : asset.records) ++records[record.level];
  return records;
}

Json toJson(const AssetReader& reader) {
  const Asset& asset = reader.asset();
  const asset::Info& info = asset.info;
  const Summary summary = summarise(reader);
  return {{"file", reader.path().string()},
          {"version", fmt::format("{}.{}", reader.header().majorVersion, reader.header().minorVersion)},
          {"scheme", asset::schemeName(asset.scheme)},
          {"provenance", asset.provenance},
          {"bounds", {{"min", info.boundsMin}, {"max", info.boundsMax}}},
          {"atlas",
           {{"width", info.atlasWidth},
            {"height", info.atlasHeight},
            {"coveredTexels", summary.coveredTexels},
            {"recordsOfLevels", recordsOfLevels(asset)}}},
          {"views", {{"frequency", info.viewFrequency}, {"count", info.viewCount}}},
          {"counts",
           {{"vertices", info.vertexCount},
            {"triangles", info.triangleCount},
            {"materials", info.materialCount},
            {"textures", info.textureCount},
            {"records", info.recordCount},
            {"tiles", info.tileCount}}},
          {"visibilityMaps", mapsToJson(reader)},
          {"coarseViews", coarseViewsToJson(asset)},
          {"cells", cellsToJson(asset)},
          {"materialTerms", materialTerms(asset)},
          {"bytes", bytesToJson(reader, summary)}};
}

void printPages(const char* name, const Json& pages) {
  fmt::print(
      "  {:<8} {:>12} {:>13}  {} pages, {} kernels of {:.1f} boxes; a record: {:.1f} kernels, {:.0f} bytes; "
      "a box: {:.2f} bytes\n",
      name, pages["stored"].get<uint64_t>(), pages["raw"].get<uint64_t>(), pages["pages"].get<uint64_t>(),
      pages["kernels"].get<uint64_t>(), pages["boxesPerKernel"].get<double>(),
      pages["kernelsPerRecord"].get<double>(), pages["storedPerRecord"].get<double>(),
      pages["storedPerBox"].get<double>());
}

void printBytes(const Json& bytes) {
  fmt::print("bytes            stored           raw\n");
  fmt::print("  {:<8} {:>12}\n  {:<8} {:>12}\n", "head", bytes["head"].get<uint64_t>(), "padding",
             bytes["padding"].get<uint64_t>());
  for (const Json& entry : bytes["chunks"])
    fmt::print("  {:<8} {:>12} {:>13}  {}\n", entry["type"].get<std::string>(),
               entry["stored"].get<uint64_t>(), entry["raw"].get<uint64_t>(),
               entry["codec"].get<std::string>());
  printPages(" glossy", bytes["glossyPages"]);
  printPages(" diffuse", bytes["diffusePages"]);
  if (bytes["cellPages"]["pages"] != 0) printPages(" cells", bytes["cellPages"]);
  fmt::print("  {:<8} {:>12}                {:.0f} bytes a record\n", "all", bytes["file"].get<uint64_t>(),
             bytes["perRecord"].get<double>());
}

/// Strings without their quotes, but with control characters still escaped: the text is the file's, not ours.
std::string plain(const Json& value) {
  const std::string text = value.dump();
  return value.is_string() ? text.substr(1, text.size() - 2) : text;
}

std::string pointText(const Json& point) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", point[0].get<double>(), point[1].get<double>(),
                     point[2].get<double>());
}

void printText(const Json& summary) {
  const auto print = [](const char* name, const std::string& value) {
    fmt::print("{:<12} {}\n", name, value);
  };
  const Json &atlas = summary["atlas"], &views = summary["views"];
  print("file", summary["file"].get<std::string>());
  print("format", fmt::format("{}, scheme {}", summary["version"].get<std::string>(),
                              summary["scheme"].get<std::string>()));
  for (const auto& [key, value] : summary["provenance"].items()) print(plain(key).c_str(), plain(value));
  print("bounds",
        fmt::format("{} to {} m", pointText(summary["bounds"]["min"]), pointText(summary["bounds"]["max"])));
  print("atlas", fmt::format("{}x{} texels, {} with a record", atlas["width"].dump(), atlas["height"].dump(),
                             atlas["coveredTexels"].dump()));
  if (const Json& levels = atlas["recordsOfLevels"]; levels.size() > 1)
    print("levels", fmt::format("{}, of {} records", levels.size(), levels.dump()));
  print("views", fmt::format("{} (frequency {})", views["count"].dump(), views["frequency"].dump()));
  for (const auto& [key, value] : summary["counts"].items()) print(key.c_str(), value.dump());
  for (const auto& [key, value] : summary["materialTerms"].items())
    print("", fmt::format("{} material{} with {}", value.dump(), value == 1 ? "" : "s", key));
  if (const Json& maps = summary["visibilityMaps"]; maps["count"] != 0)
    print("visibility", fmt::format("{} maps of split records, {} bytes of {}", maps["count"].dump(),
                                    maps["stored"].dump(), maps["raw"].dump()));
  const auto printSphere = [&](const char* name, const Json& sphere) {
    if (sphere["count"] != 0)
      print(name, fmt::format("{} (frequency {}), of {} records", sphere["count"].dump(),
                              sphere["frequency"].dump(), sphere["records"].dump()));
  };
  for (const Json& sphere : summary["coarseViews"]) printSphere("views", sphere);
  printSphere("cells", summary["cells"]);
  const Json& bytes = summary["bytes"];
  for (const char* kind : {"glossyPages", "diffusePages", "cellPages"})
    if (const Json& emitted = bytes[kind]["emittedKernels"]; emitted != 0)
      print("emission", fmt::format("in {} kernels of the {}", emitted.dump(), kind));
  printBytes(bytes);
}

void inspect(const std::string& path, bool json) {
  const Json summary = toJson(AssetReader(path));
  if (json)
    fmt::print("{}\n", summary.dump(2, ' ', false, Json::error_handler_t::replace));
  else
    printText(summary);
}

}  // namespace

void addInspectCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("inspect", "Show what an asset holds and what its bytes are spent on");
  addCommonOptions(*command, common);
  const auto path = std::make_shared<std::string>();
  command->add_option("ASSET", *path, "The .ptb file")->required();
  command->callback([path, &common] { inspect(*path, common.json); });
}

}  // namespace boxlight
