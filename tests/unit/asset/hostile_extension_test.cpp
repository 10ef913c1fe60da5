// SPDX-License-Identifier: Apache-2.0
// What format 1.1 added, with values that no writer would write.
#include "tests/unit/asset/hostile.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

// In makeSample(): pages with light boxes alone and with emitted radiance, two views of one tile.
constexpr size_t kBoxPage = 0, kLambertPage = 24, kEmittedView1 = 3;

std::function<void(Surgeon&)> inExtension(std::function<void(MaterialExtension&)> change) {
  return in<MaterialExtension>(chunk::kMaterialExtensions, 1, std::move(change));
}
std::function<void(Surgeon&)> inMaterial(std::function<void(Material&)> change) {
  return in<Material>(chunk::kMaterials, 1, std::move(change));
}
void removeExtensions(Surgeon& s) {
  for (size_t i = 0; i < 2; ++i) s.edit<Material>(chunk::kMaterials, i, [](Material& m) { m.flags = 0; });
  s.removeChunk(chunk::kMaterialExtensions);
}

const PackedBox kCosine = packCosineBox({{0, 0.25f, 1, 0.5f}, 1});

const std::vector<Case> kCases = {
    {"flagsNeedExtensions", extensionMissing, [](Surgeon& s) { s.removeChunk(chunk::kMaterialExtensions); }},
    {"emissionNeedsExtensions", extensionMissing, removeExtensions},
    {"extensionCount", counts,
     [](Surgeon& s) { s.setChunk(chunk::kMaterialExtensions, Bytes(sizeof(MaterialExtension))); }},
    {"halfAnExtension", chunkSize, [](Surgeon& s) { s.setChunk(chunk::kMaterialExtensions, Bytes(211)); }},
    {"extensionsTwice", chunkDuplicate,
     [](Surgeon& s) { s.addChunk(chunk::kMaterialExtensions, Bytes(424)); }},
    {"extensionsPaged", chunkCodec,
     inEntry(chunk::kMaterialExtensions, [](ChunkEntry& e) { e.codec = Codec::pages; })},
    {"extensionHash", chunkHash, inEntry(chunk::kMaterialExtensions, [](ChunkEntry& e) { e.hash ^= 1; })},
    {"iorNan", notFinite, inExtension([](auto& x) { x.ior = kNan; })},
    {"anisotropyInfinite", notFinite, inExtension([](auto& x) { x.scatterAnisotropy = kInfinity; })},
    {"iorNegative", extensionValue, inExtension([](auto& x) { x.ior = -1; })},
    {"iridescenceIorZero", extensionValue, inExtension([](auto& x) { x.iridescenceIor = 0; })},
    {"emissiveNegative", extensionValue, inExtension([](auto& x) { x.emissive[2] = -1; })},
    {"absorptionNegative", extensionValue, inExtension([](auto& x) { x.absorption[0] = -1; })},
    {"scatteringNegative", extensionValue, inExtension([](auto& x) { x.scattering[1] = -1; })},
    {"scatterForwards", extensionValue, inExtension([](auto& x) { x.scatterAnisotropy = 1; })},
    {"scatterBackwards", extensionValue, inExtension([](auto& x) { x.scatterAnisotropy = -1; })},
    {"extensionTexture", materialTexture, inExtension([](auto& x) { x.anisotropyTexture.texture = 2; })},
    {"extensionTexcoord", materialTexture, inExtension([](auto& x) { x.emissiveTexture.texcoord = 2; })},
    {"extensionTransform", materialTexture, inExtension([](auto& x) { x.sheenColorTexture.transform = 3; })},
    {"coreTransform", materialTexture, inMaterial([](auto& m) { m.baseColorTexture.transform = 65535; })},
    {"transformsGone", materialTexture, [](Surgeon& s) { s.removeChunk(chunk::kTextureTransforms); }},
    {"transformNan", notFinite,
     in<TextureTransform>(chunk::kTextureTransforms, 1, [](auto& t) { t.rows[1][2] = kNan; })},
    {"tooManyTransforms", limits,
     [](Surgeon& s) {
       s.setChunk(chunk::kTextureTransforms, Bytes((kMaxTextureTransforms + 1) * sizeof(TextureTransform)));
     }},
    {"unknownKind", boxKind, inBox(kBoxPage, 0, [](auto& b) { b.kind = 4; })},
    {"emittedInSlot1", boxKind, inBox(kLambertPage, 1, [](auto& b) { b = packEmission(Rgb(1.0f)); })},
    {"oneKernelEmitted", emittedSlots, inBox(kBoxPage, 3, [](auto& b) { b = packEmission(Rgb(1.0f)); })},
    {"oneViewNotEmitted", emittedSlots, inBox(kEmittedView1, 0, [](auto& b) { b = PackedBox(); })},
    {"emittedExponentHigh", boxRange, inBox(kLambertPage, 0, [](auto& b) { b.du = 32768 + 129; })},
    {"emittedExponentLow", boxRange, inBox(kLambertPage, 4, [](auto& b) { b.du = 32768 - 149; })},
    {"emittedTooLarge", boxRange,
     inBox(kLambertPage, 0, [](auto& b) { b.du = 32768 + 128, b.energy[0] = 0x4000; })},
    {"emittedNegative", boxEnergy, inBox(kLambertPage, 0, [](auto& b) { b.energy[1] = 0xBC00; })},
    {"cosineOffItsRaster", boxRange,
     inBox(kLambertPage, 1, [](auto& b) { b = kCosine, b.v0 += 1, b.dv -= 1; })},
    {"cosineEndsOffItsRaster", boxRange, inBox(kLambertPage, 1, [](auto& b) { b = kCosine, b.dv += 1; })},
    {"cosineBelowTheDomain", boxRange, inBox(kLambertPage, 1, [](auto& b) { b = kCosine, b.dv += 32768; })},
    {"cosineInfinite", boxEnergy, inBox(kLambertPage, 1, [](auto& b) { b = kCosine, b.energy[0] = 0xFC00; })},
    {"emittedNan", boxEnergy, inBox(kLambertPage, 0, [](auto& b) { b.energy[1] = 0x7E00; })},
};

const std::vector<Case> kHarmless = {
    {"iorBelowOne", materialValue, inExtension([](auto& x) { x.ior = 0.5f; })},
    {"iridescenceIorBelowOne", materialValue, inExtension([](auto& x) { x.iridescenceIor = 0.5f; })},
    {"clearcoatAboveOne", materialValue, inExtension([](auto& x) { x.clearcoat = 2; })},
    {"sheenAboveOne", materialValue, inExtension([](auto& x) { x.sheenColor[1] = 2; })},
    {"thicknessNegative", materialValue, inExtension([](auto& x) { x.iridescenceThickness[1] = -1; })},
    {"maskAndBlend", materialValue, inMaterial([](auto& m) { m.flags |= kAlphaMask; })},
    {"boxesBesideEmission", kernelEnergy, inBox(kLambertPage, 1, [](auto& b) { b.energy[0] = 0x4900; })},
};

INSTANTIATE_TEST_SUITE_P(Extension, Hostile, ::testing::ValuesIn(kCases), kCaseName);
INSTANTIATE_TEST_SUITE_P(Extension, Harmless, ::testing::ValuesIn(kHarmless), kCaseName);

const PackedBox kTakesAway = packCosineBox({{0, 0, 1, 1}, -2});
TEST(Extension, CosineBoxesMayTakeAway) {
  const Validation validation =
      validationAfter({}, inBox(kLambertPage, 1, [](PackedBox& b) { b = kTakesAway; }));
  EXPECT_TRUE(validation.count.empty());
}

Validation afterwards(const std::function<void(Surgeon&)>& operate) { return validationAfter({}, operate); }

TEST(Extensions, EmittedRadianceIsNoEnergyOfAKernel) {
  EXPECT_TRUE(afterwards(inBox(kLambertPage, 0, [](auto& b) { b.energy[0] = 0x7BFF; })).count.empty());
}

TEST(Extensions, EmittedRadianceMeansNothingByItsEdges) {
  EXPECT_TRUE(afterwards(inBox(kLambertPage, 0, [](auto& b) { b.v0 = b.dv = 65535; })).count.empty());
}

TEST(Extensions, ATableWithoutEntriesIsAsGoodAsNone) {
  const Validation validation = afterwards([](Surgeon& s) { s.setChunk(chunk::kMaterialExtensions, {}); });
  EXPECT_TRUE(validation.count.contains(extensionMissing));
  EXPECT_FALSE(validation.count.contains(counts));
}

TEST(Extensions, NothingIsSaidOfFlagsIfTheTableIsUnreadable) {
  const Validation validation = afterwards([](Surgeon& s) { s.entry(chunk::kMaterialExtensions).hash ^= 1; });
  for (const Finding& finding : validation.findings) EXPECT_NE(finding.chunk, "MATL") << finding.message();
}

}  // namespace
}  // namespace boxlight::asset
