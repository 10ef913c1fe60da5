// SPDX-License-Identifier: Apache-2.0
// The texels of the atlas and its levels, and the records that they show.
#include <array>
#include <cmath>

#include "common/asset/asset_checks.h"
#include "common/asset/number_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

/// Is a record's texel in the atlas?
void checkTexel(const Asset& asset, uint32_t index, const Reporter& report) {
  const TexelRecord& r = asset.records[index];
  const std::string place = fmt::format("record {}", index);
  if (r.level >= std::max(asset.levelCount(), 1u))
    return report(atlasLevels, chunk::kRecords, place, "level {} of the atlas does not exist", r.level);
  const uvec2 size = asset.levelSize(r.level);
  if (r.atlasX >= size.x || r.atlasY >= size.y)
    report(recordTexel, chunk::kRecords, place, "outside the atlas");
}

void checkRecord(const Asset& asset, const ChunkSet& present, uint32_t index, const Reporter& report) {
  const TexelRecord& r = asset.records[index];
  const auto bad = [&](FindingCode code, const char* what) {
    report(code, chunk::kRecords, fmt::format("record {}", index), "{}", what);
  };
  const std::array numbers = {allFinite(r.position), allFinite(r.normal),        allFinite(r.tangent),
                              allFinite(r.f0),       std::isfinite(r.roughness), std::isfinite(r.metallic)};
  if (std::find(numbers.begin(), numbers.end(), false) != numbers.end())
    return bad(notFinite, "NaN or infinite");
  if (!isUnit(r.normal)) bad(recordFrame, "the normal is not unit");
  if (!isUnit(r.tangent)) bad(recordFrame, "the tangent is not unit");
  if (!isFraction(r.roughness)) bad(recordValue, "roughness outside [0,1]");
  if (!isFraction(r.metallic)) bad(recordValue, "metallic outside [0,1]");
  if (!std::all_of(std::begin(r.f0), std::end(r.f0), isFraction)) bad(recordValue, "f0 outside [0,1]");
  if (present.has({chunk::kMaterials}) && r.material >= asset.materials.size())
    bad(recordMaterial, "no such material");
  if (present.has({chunk::kInfo, chunk::kAtlasLevels})) checkTexel(asset, index, report);
  if ((r.flags & ~kKnownRecordFlags) != 0 || r.emissionSlot != kNone)
    bad(reserved, "unknown flags or emissionSlot");
}

/// One side of texel `index` of a chunk.
void checkSide(const Asset& asset, uint32_t chunk, size_t index, uint32_t level, bool back,
               const Reporter& report) {
  const AtlasTexel& texel = (level == 0 ? asset.atlas : asset.atlasLevels)[index];
  const uint32_t record = back ? texel.back : texel.front;
  if (record == kNone) return;
  const auto bad = [&](FindingCode code, const std::string& what) {
    report(code, chunk, fmt::format("texel {}, {}", index, back ? "back" : "front"), "record {} {}", record,
           what);
  };
  if (record >= asset.records.size()) return bad(atlasRecord, fmt::format("of {}", asset.records.size()));
  const TexelRecord& shown = asset.records[record];
  if (bool(shown.flags & kBackSide) != back) bad(atlasRecord, "is of the other side");
  if (shown.level != level) bad(atlasLevels, fmt::format("is of level {}", shown.level));
}

void checkLevels(const Asset& asset, const Reporter& report) {
  if (asset.levelCount() == 0)
    return report(atlasLevels, chunk::kAtlasLevels, "",
                  "{} texels are not those of whole levels of a {}x{} atlas", asset.atlasLevels.size(),
                  asset.info.atlasWidth, asset.info.atlasHeight);
  size_t at = 0;
  for (uint32_t level = 1; level < asset.levelCount(); ++level) {
    const uvec2 size = asset.levelSize(level);
    for (const size_t end = at + size_t(size.x) * size.y; at < end; ++at)
      for (const bool back : {false, true}) checkSide(asset, chunk::kAtlasLevels, at, level, back, report);
  }
}

}  // namespace

void checkAtlas(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  if (present.has({chunk::kInfo, chunk::kAtlas})) {
    const uint64_t texels = uint64_t(asset.info.atlasWidth) * asset.info.atlasHeight;
    if (asset.atlas.size() != texels)
      report(counts, chunk::kAtlas, "", "{} entries, the atlas has {} texels", asset.atlas.size(), texels);
  }
  for (uint32_t i = 0; i < asset.records.size(); ++i) checkRecord(asset, present, i, report);
  if (!present.has({chunk::kRecords})) return;
  for (size_t i = 0; present.has({chunk::kAtlas}) && i < asset.atlas.size(); ++i)
    for (const bool back : {false, true}) checkSide(asset, chunk::kAtlas, i, 0, back, report);
  if (present.has({chunk::kInfo, chunk::kAtlasLevels})) checkLevels(asset, report);
}

}  // namespace boxlight::asset
