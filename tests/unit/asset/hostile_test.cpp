// SPDX-License-Identifier: Apache-2.0
// Values that no writer would write, behind correct hashes.
#include "tests/unit/asset/hostile.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

Bytes text(const std::string& characters) {
  const auto bytes = std::as_bytes(std::span(characters));
  return {bytes.begin(), bytes.end()};
}

std::function<void(Surgeon&)> provenanceText(std::string characters) {
  return [=](Surgeon& s) { s.setChunk(chunk::kProvenance, text(characters)); };
}

std::string nested(int depth) {
  return "{\"a\":" + std::string(size_t(depth), '[') + std::string(size_t(depth), ']') + "}";
}

constexpr Codec kNoCodec = Codec(uint32_t(Codec::planes) + 1);

const std::vector<Case> kHeadCases = {
    {"majorVersion", majorVersion, [](Surgeon& s) { s.header.majorVersion = 2; }},
    {"majorVersionZero", majorVersion, [](Surgeon& s) { s.header.majorVersion = 0; }},
    {"scheme", scheme, [](Surgeon& s) { s.header.scheme = Scheme(4); }},
    {"schemeZero", scheme, [](Surgeon& s) { s.header.scheme = Scheme(0); }},
    {"hugeChunkCount", chunkTable, [](Surgeon& s) { s.seal = false, s.header.chunkCount = 0xFFFFFFFFu; }},
    {"tooManyChunks", chunkTable, [](Surgeon& s) { s.seal = false, s.header.chunkCount = kMaxChunks + 1; }},
    {"oneChunkTooMany", chunkTable,
     [](Surgeon& s) {
       while (s.table.size() <= kMaxChunks) s.addChunk(fourCc("vism"), {});
     }},
    {"noChunks", chunkMissing, [](Surgeon& s) { s.table.clear(); }},
    {"offsetNearTop", chunkRange, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.offset = ~uint64_t(15); })},
    {"sizeNearTop", chunkRange,
     inEntry(chunk::kVertices, [](ChunkEntry& e) { e.storedSize = ~uint64_t(0); })},
    {"sumWraps", chunkRange, inEntry(chunk::kTiles, [](ChunkEntry& e) { e.storedSize = 0 - e.offset; })},
    {"onTheHead", chunkRange, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.offset = 0; })},
    {"unaligned", chunkRange, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.offset += 8; })},
    {"overlap", chunkOverlap,
     [](Surgeon& s) {
       ChunkEntry &a = s.entry(chunk::kVertices), &b = s.entry(chunk::kTriangles);
       a.storedSize = b.offset + 1 - a.offset;
       a.rawSize = a.storedSize;
     }},
    {"duplicate", chunkDuplicate, [](Surgeon& s) { s.addChunk(chunk::kInfo, s.chunk(chunk::kInfo)); }},
    {"missing", chunkMissing, [](Surgeon& s) { s.removeChunk(chunk::kStreamMasks); }},
    {"unknownRequired", chunkUnknown, [](Surgeon& s) { s.addChunk(fourCc("ZZZZ"), Bytes(4)); }},
    {"unknownNotALetter", chunkUnknown, [](Surgeon& s) { s.addChunk(0x1B5B3001, Bytes(4)); }},
    {"unknownCodec", chunkCodec, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.codec = kNoCodec; })},
    {"unknownCodecTop", chunkCodec,
     inEntry(chunk::kVertices, [](ChunkEntry& e) { e.codec = Codec(0xFFFFFFFFu); })},
    {"unknownCodecOfPages", chunkCodec, inEntry(chunk::kPages, [](ChunkEntry& e) { e.codec = kNoCodec; })},
    {"pagedTable", chunkCodec, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.codec = Codec::pages; })},
    {"tableInPlanes", chunkCodec, inEntry(chunk::kVertices, [](ChunkEntry& e) { e.codec = Codec::planes; })},
    {"unpagedPages", chunkCodec, inEntry(chunk::kPages, [](ChunkEntry& e) { e.codec = Codec::none; })},
    {"unpagedFrame", chunkCodec, inEntry(chunk::kPages, [](ChunkEntry& e) { e.codec = Codec::zstd; })},
    {"rawSizeOfPlainChunk", chunkSize,
     inEntry(chunk::kInfo, [](ChunkEntry& e) { e.rawSize = uint64_t(1) << 40; })},
    {"bomb", chunkSize,
     inEntry(chunk::kInfo, [](ChunkEntry& e) { e.codec = Codec::zstd, e.rawSize = kFreeExpansion + 1; })},
    {"bombNearTop", chunkSize,
     inEntry(chunk::kInfo, [](ChunkEntry& e) { e.codec = Codec::zstd, e.rawSize = ~uint64_t(0); })},
    {"noFrame", chunkFrame, inEntry(chunk::kTexels, [](ChunkEntry& e) { e.codec = Codec::zstd; })},
    {"frameThenSkippableFrame", chunkFrame,
     [](Surgeon& s) {
       s.setFrame(chunk::kInfo, s.chunk(chunk::kInfo), text(std::string("\x50\x2A\x4D\x18\0\0\0\0", 8)));
     }},
    {"frameOfAnotherSize", chunkFrame,
     inEntry(chunk::kInfo, [](ChunkEntry& e) { e.rawSize += sizeof(Info); })},
    {"halfAnEntry", chunkSize, [](Surgeon& s) { s.setChunk(chunk::kVertices, Bytes(81)); }},
    {"twoInfos", chunkSize, [](Surgeon& s) { s.setChunk(chunk::kInfo, Bytes(2 * sizeof(Info))); }},
    {"provenanceNotJson", provenance, provenanceText("{\"tool\":")},
    {"provenanceNotAnObject", provenance, provenanceText("[1]")},
    {"provenanceNotUtf8", provenance, provenanceText("{\"tool\":\"\xC3\x28\"}")},
    {"provenanceHugeNumber", provenance, provenanceText("{\"seed\":1e999}")},
    {"provenanceTooDeep", provenance, provenanceText(nested(40))},
    {"provenanceFarTooDeep", provenance, provenanceText(nested(400000))},
    {"provenanceTooLong", provenance,
     provenanceText("{\"a\":\"" + std::string(kMaxProvenanceSize, ' ') + "\"}")},
};

const std::vector<Case> kTableCases = {
    {"vertexCount", counts, in<Info>(chunk::kInfo, 0, [](Info& i) { i.vertexCount = 0xFFFFFFFFu; })},
    {"recordCount", counts, in<Info>(chunk::kInfo, 0, [](Info& i) { i.recordCount -= 1; })},
    {"tileCount", counts, in<Info>(chunk::kInfo, 0, [](Info& i) { i.tileCount += 1; })},
    {"atlasSize", counts, in<Info>(chunk::kInfo, 0, [](Info& i) { i.atlasWidth += 1; })},
    {"atlasHuge", limits, in<Info>(chunk::kInfo, 0, [](Info& i) { i.atlasWidth = 0xFFFFFFFFu; })},
    {"atlasZero", limits, in<Info>(chunk::kInfo, 0, [](Info& i) { i.atlasHeight = 0; })},
    {"frequencyZero", limits,
     in<Info>(chunk::kInfo, 0, [](Info& i) { i.viewFrequency = 0, i.viewCount = 2; })},
    {"frequencyHuge", limits, in<Info>(chunk::kInfo, 0, [](Info& i) { i.viewFrequency = 0x80000000u; })},
    {"viewCount", viewCount, in<Info>(chunk::kInfo, 0, [](Info& i) { i.viewCount = 13; })},
    {"viewCountTop", viewCount, in<Info>(chunk::kInfo, 0, [](Info& i) { i.viewCount = 0xFFFFFFFFu; })},
    {"frequencyOfOthers", counts,
     in<Info>(chunk::kInfo, 0, [](Info& i) { i.viewFrequency = 2, i.viewCount = 42; })},
    {"boundsNan", notFinite, in<Info>(chunk::kInfo, 0, [](Info& i) { i.boundsMax[1] = kNan; })},
    {"positionNan", notFinite, in<Vertex>(chunk::kVertices, 3, [](Vertex& v) { v.position[1] = kNan; })},
    {"colorInfinite", notFinite, in<Vertex>(chunk::kVertices, 6, [](Vertex& v) { v.color[3] = kInfinity; })},
    {"vertexIndex", triangleVertex, in<Triangle>(chunk::kTriangles, 2, [](Triangle& t) { t.vertex[1] = 7; })},
    {"vertexIndexTop", triangleVertex,
     in<Triangle>(chunk::kTriangles, 4, [](Triangle& t) { t.vertex[2] = kNone; })},
    {"triangleMaterial", triangleMaterial,
     in<Triangle>(chunk::kTriangles, 0, [](Triangle& t) { t.material = 2; })},
    {"factorNan", notFinite,
     in<Material>(chunk::kMaterials, 1, [](Material& m) { m.specularColor[2] = kNan; })},
    {"textureIndex", materialTexture,
     in<Material>(chunk::kMaterials, 1, [](Material& m) { m.normalTexture.texture = 2; })},
    {"texcoord", materialTexture,
     in<Material>(chunk::kMaterials, 1, [](Material& m) { m.specularColorTexture.texcoord = 2; })},
    {"textureZero", limits, in<Texture>(chunk::kTextures, 0, [](Texture& t) { t.width = 0; })},
    {"textureHuge", limits, in<Texture>(chunk::kTextures, 0, [](Texture& t) { t.width = t.height = 65536; })},
    {"texelsBeyond", textureLayout, in<Texture>(chunk::kTextures, 1, [](Texture& t) { t.firstTexel = 9; })},
    {"texelsTop", textureLayout, in<Texture>(chunk::kTextures, 1, [](Texture& t) { t.firstTexel = kNone; })},
    {"wrap", textureLayout, in<Texture>(chunk::kTextures, 1, [](Texture& t) { t.wrapT = Wrap(3); })},
    {"minFilter", textureLayout, in<Texture>(chunk::kTextures, 1, [](Texture& t) { t.minFilter = 3; })},
    {"atlasRecord", atlasRecord, in<AtlasTexel>(chunk::kAtlas, 9, [](AtlasTexel& t) { t.front = 5; })},
    {"atlasRecordTop", atlasRecord,
     in<AtlasTexel>(chunk::kAtlas, 9, [](AtlasTexel& t) { t.back = kNone - 1; })},
    {"atlasOtherSide", atlasRecord, in<AtlasTexel>(chunk::kAtlas, 9, [](AtlasTexel& t) { t.back = 0; })},
    {"recordNan", notFinite, in<TexelRecord>(chunk::kRecords, 1, [](TexelRecord& r) { r.f0[0] = kNan; })},
    {"recordNormal", recordFrame,
     in<TexelRecord>(chunk::kRecords, 1, [](TexelRecord& r) { r.normal[0] = 3; })},
    {"recordRoughness", recordValue,
     in<TexelRecord>(chunk::kRecords, 1, [](TexelRecord& r) { r.roughness = 1.5f; })},
    {"recordMaterial", recordMaterial,
     in<TexelRecord>(chunk::kRecords, 4, [](TexelRecord& r) { r.material = 2; })},
    {"recordTexel", recordTexel,
     in<TexelRecord>(chunk::kRecords, 4, [](TexelRecord& r) { r.atlasY = 1000; })},
};

const std::vector<Case> kPageCases = {
    {"tileGap", tileRange, in<Tile>(chunk::kTiles, 1, [](Tile& t) { t.firstRecord += 1; })},
    {"tileShort", tileRange, in<Tile>(chunk::kTiles, 1, [](Tile& t) { t.recordCount -= 1; })},
    {"tileEmpty", tileRange, in<Tile>(chunk::kTiles, 0, [](Tile& t) { t.recordCount = 0; })},
    {"tileHuge", tileRange, in<Tile>(chunk::kTiles, 1, [](Tile& t) { t.recordCount = 0xFFFFFFFFu; })},
    {"tileBoxes", tileBoxes, in<Tile>(chunk::kTiles, 0, [](Tile& t) { t.glossyBoxes = 0x10000001u; })},
    {"maskBits", maskBits, in<uint64_t>(chunk::kStreamMasks, 0, [](uint64_t& m) { m |= 8; })},
    {"maskTopBit", maskBits,
     in<uint64_t>(chunk::kStreamMasks, 0, [](uint64_t& m) { m |= uint64_t(1) << 63; })},
    {"maskWithoutBoxes", maskBits, in<Tile>(chunk::kTiles, 0, [](Tile& t) { t.glossyBoxes = 0; })},
    {"maskMissingOne", counts,
     [](Surgeon& s) {
       Bytes masks = s.chunk(chunk::kStreamMasks);
       masks.resize(masks.size() - 8);
       s.setChunk(chunk::kStreamMasks, masks);
     }},
    {"indexMissingOne", counts,
     [](Surgeon& s) {
       Bytes index = s.chunk(chunk::kPageIndex);
       index.resize(index.size() - sizeof(PageEntry));
       s.setChunk(chunk::kPageIndex, index);
     }},
    {"noTilesButMasks", counts, [](Surgeon& s) { s.setChunk(chunk::kTiles, {}); }},
    {"pageRawSize", pageSize, in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.rawSize += 16; })},
    {"pageRawSizeTop", pageSize,
     in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.rawSize = 0xFFFFFFF0u; })},
    {"pageEmpty", pageSize, in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.storedSize = 0; })},
    {"pageUnexpected", pageSize,
     in<PageEntry>(chunk::kPageIndex, 1, [](PageEntry& p) { p.storedSize = 16; })},
    {"pageOffsetTop", pageRange,
     in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.offset = ~uint64_t(0); })},
    {"pageOffsetWraps", pageRange,
     in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.offset = 0 - uint64_t(p.storedSize); })},
    {"pageTooLong", pageRange,
     in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.storedSize = 0xFFFFFFFFu; })},
    {"pageHash", pageHash, in<PageEntry>(chunk::kPageIndex, 0, [](PageEntry& p) { p.hash ^= 1; })},
    {"pageNotAFrame", pageFrame,
     [](Surgeon& s) {
       Bytes pages = s.chunk(chunk::kPages);
       pages.resize(pages.size() + 7);
       s.setChunk(chunk::kPages, pages);
       s.edit<PageEntry>(chunk::kPageIndex, 0, [&](PageEntry& p) {
         p = {pages.size() - 7, 7, p.rawSize, xxh64(std::span(pages).last(7))};
       });
     }},
    {"pageOfAnother", pageFrame,
     [](Surgeon& s) {
       const Bytes index = s.chunk(chunk::kPageIndex);
       PageEntry other;
       std::memcpy(&other, &index[index.size() - sizeof other], sizeof other);
       s.edit<PageEntry>(chunk::kPageIndex, 0, [&](PageEntry& p) { other.rawSize = p.rawSize, p = other; });
     }},
    {"boxTooTall", boxRange,
     [](Surgeon& s) { s.editBox(0, 2, [](PackedBox& b) { b.v0 = 1, b.dv = 65535; }); }},
    {"energyNegative", boxEnergy,
     [](Surgeon& s) { s.editBox(0, 1, [](PackedBox& b) { b.energy[2] = 0xBC00; }); }},
    {"energyInfinite", boxEnergy,
     [](Surgeon& s) { s.editBox(0, 1, [](PackedBox& b) { b.energy[0] = 0x7C00; }); }},
    {"energyNan", boxEnergy, [](Surgeon& s) { s.editBox(0, 1, [](PackedBox& b) { b.energy[1] = 0x7E00; }); }},
};

const std::vector<Case> kHarmless = {
    {"newerMinor", newerMinor, [](Surgeon& s) { s.header.minorVersion = kMinorVersion + 1; }},
    {"reservedHeader", reserved, [](Surgeon& s) { s.header.reserved = 5; }},
    {"unknownOptional", chunkSkipped, [](Surgeon& s) { s.addChunk(fourCc("vism"), Bytes(100)); }},
    {"unknownOptionalTwice", chunkSkipped,
     [](Surgeon& s) { s.addChunk(fourCc("vism"), Bytes(100)), s.addChunk(fourCc("vism"), Bytes(0)); }},
    {"unknownOptionalPages", chunkSkipped,
     [](Surgeon& s) {
       s.addChunk(fourCc("visp"), Bytes(9)), s.table.back().codec = Codec::pages, s.table.back().hash = 0;
     }},
    {"unknownOptionalCodec", chunkSkipped,
     [](Surgeon& s) { s.addChunk(fourCc("visp"), Bytes(9)), s.table.back().codec = Codec(9); }},
    {"bounds", bounds, in<Vertex>(chunk::kVertices, 0, [](Vertex& v) { v.position[0] = 2; })},
    {"vertexNormal", vertexFrame, in<Vertex>(chunk::kVertices, 0, [](Vertex& v) { v.normal[0] = 2; })},
    {"bitangentSign", vertexFrame, in<Vertex>(chunk::kVertices, 0, [](Vertex& v) { v.tangent[3] = 0; })},
    {"atlasUv", vertexAtlasUv, in<Vertex>(chunk::kVertices, 0, [](Vertex& v) { v.atlasUv[0] = -0.5f; })},
    {"materialValue", materialValue, in<Material>(chunk::kMaterials, 0, [](Material& m) { m.metallic = 2; })},
    {"materialFlag", reserved, in<Material>(chunk::kMaterials, 0, [](Material& m) { m.flags |= 0x80; })},
    {"kernelEnergy", kernelEnergy,
     [](Surgeon& s) { s.editBox(0, 0, [](PackedBox& b) { b.energy[0] = 0x4900; }); }},
    {"energyNegativeZero", kernelEnergy,
     [](Surgeon& s) { s.editBox(0, 0, [](PackedBox& b) { b.energy[0] = 0x4900, b.energy[1] = 0x8000; }); }},
};

/// The same in a file of Codec::pages, as versions up to 1.4 wrote them.
std::vector<Case> boxByBox(std::vector<Case> cases) {
  for (Case& c : cases)
    c.operate = [operate = c.operate](Surgeon& s) {
      s.setPageCodec(Codec::pages);
      operate(s);
    };
  return cases;
}

TEST_P(Hostile, endsInAnErrorOfItsKind) {
  const ExitCode expected = findingKind(GetParam().code).exitCode;
  EXPECT_TRUE(validation.count.contains(GetParam().code)) << found();
  EXPECT_NE(validation.exitCode(), ExitCode::ok);
  try {
    contentHash(file.path);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == expected || error.code() == ExitCode::invalidInput) << error.what();
    EXPECT_EQ(std::string(error.what()).find(file.path.string()), 0u) << error.what();
  }
}

TEST_P(Harmless, isReadAndMentioned) {
  EXPECT_TRUE(validation.count.contains(GetParam().code)) << found();
  EXPECT_EQ(validation.exitCode(), ExitCode::ok) << found();
  EXPECT_NO_THROW(contentHash(file.path));
}

INSTANTIATE_TEST_SUITE_P(Head, Hostile, ::testing::ValuesIn(kHeadCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(Table, Hostile, ::testing::ValuesIn(kTableCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(Page, Hostile, ::testing::ValuesIn(kPageCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(PageOfBoxes, Hostile, ::testing::ValuesIn(boxByBox(kPageCases)), kCaseName);
INSTANTIATE_TEST_SUITE_P(File, Harmless, ::testing::ValuesIn(kHarmless), kCaseName);

TEST(Validate, eitherLayoutOfPagesIsTheSameAsset) {
  const TemporaryFile planes, boxes;
  makeSample({.records = 70, .recordsPerTile = 64}).write(planes.path);
  Surgeon surgeon(readFile(planes.path));
  surgeon.setPageCodec(Codec::pages);
  surgeon.write(boxes.path);
  EXPECT_EQ(contentHash(planes.path), contentHash(boxes.path));
  EXPECT_EQ(validateAsset(boxes.path).exitCode(), ExitCode::ok);
}

/// The codec is no matter of taste: boxes read as planes are other boxes.
TEST(Validate, pagesUnderTheOtherCodecAreNotTheSame) {
  const TemporaryFile right, wrong;
  makeSample().write(right.path);
  Surgeon surgeon(readFile(right.path));
  surgeon.entry(chunk::kPages).codec = Codec::pages;
  surgeon.write(wrong.path);
  EXPECT_NE(validateAsset(wrong.path).exitCode(), ExitCode::ok);
}

TEST(Validate, findsMoreThanTheFirst) {
  const TemporaryFile file;
  makeSample().write(file.path);
  Surgeon surgeon(readFile(file.path));
  for (size_t i = 0; i < 5; ++i)
    surgeon.edit<Triangle>(chunk::kTriangles, i, [](Triangle& t) { t.material = 9, t.vertex[0] = 99; });
  surgeon.edit<Vertex>(chunk::kVertices, 0, [](Vertex& v) { v.position[0] = kNan; });
  surgeon.editBox(0, 0, [](PackedBox& b) { b.energy[0] = 0x7C00; });
  surgeon.entry(chunk::kTextures).hash ^= 1;
  surgeon.write(file.path);
  const Validation validation = validateAsset(file.path);
  EXPECT_EQ(validation.count.at(triangleMaterial), 5u);
  EXPECT_EQ(validation.count.at(triangleVertex), 5u);
  EXPECT_EQ(validation.count.at(notFinite), 1u);
  EXPECT_EQ(validation.count.at(boxEnergy), 1u);
  EXPECT_EQ(validation.count.at(chunkHash), 1u);
  EXPECT_FALSE(validation.count.contains(materialTexture))
      << "the textures are unknown, so nothing can be said of references";
  EXPECT_EQ(validation.total(Severity::error), 13u);
}

}  // namespace
}  // namespace boxlight::asset
