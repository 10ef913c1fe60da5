// SPDX-License-Identifier: Apache-2.0
#include "tests/format/sample_asset.h"

#include <bit>
#include <glm/gtc/packing.hpp>
#include <random>

namespace boxlight::asset {
namespace {

/// Numbers that never repeat soon; std::mt19937 is the same everywhere, std distributions are not.
class Numbers {
 public:
  uint32_t integer(uint32_t below) { return uint32_t(engine_() % below); }
  float fraction() { return float(engine_() >> 8) / float(1 << 24); }
  vec3 unit() {
    return glm::normalize(vec3(fraction(), fraction(), fraction()) - vec3(0.5f) + vec3(0, 0, 1e-3f));
  }
  template <size_t N>
  void fill(float (&values)[N]) {
    for (float& value : values) value = fraction();
  }
  void fillUnit(float* values) {
    const vec3 v = unit();
    for (int axis = 0; axis < 3; ++axis) values[axis] = v[axis];
  }

 private:
  std::mt19937 engine_{1};
};

void addMesh(Asset& asset, Numbers& numbers) {
  for (int i = 0; i < 7; ++i) {
    Vertex v{};
    numbers.fill(v.position);
    numbers.fillUnit(v.normal);
    numbers.fillUnit(v.tangent);
    v.tangent[3] = i % 2 ? 1.0f : -1.0f;
    numbers.fill(v.atlasUv);
    for (auto& uv : v.uv) numbers.fill(uv);
    numbers.fill(v.color);
    asset.vertices.push_back(v);
  }
  for (uint32_t i = 0; i < 5; ++i) asset.triangles.push_back({{i, i + 1, i + 2}, i % 2});
  std::fill_n(asset.info.boundsMin, 3, -0.25f);
  for (int axis = 0; axis < 3; ++axis) asset.info.boundsMax[axis] = 1.0f + float(axis);
}

void addMaterials(Asset& asset, Numbers& numbers) {
  Material plain, textured;
  numbers.fill(plain.baseColor);
  plain.flags = kDoubleSided;
  numbers.fill(textured.baseColor);
  textured.metallic = 0.25f;
  textured.roughness = 0.375f;
  textured.normalScale = -2.0f;
  textured.alphaCutoff = 0.625f;
  textured.specular = 0.875f;
  numbers.fill(textured.specularColor);
  textured.flags = kAlphaMask;
  textured.baseColorTexture = {0, 1};
  textured.metallicRoughnessTexture = {1, 0};
  textured.normalTexture = {1, 1};
  textured.specularTexture = {0, 0};
  textured.specularColorTexture = {1, 1};
  asset.materials = {plain, textured};
  asset.textures = {{4, 2, 0, Wrap::clampToEdge, Wrap::mirroredRepeat, 1, 0, 2},
                    {2, 3, 8, Wrap::repeat, Wrap::clampToEdge, 0, 1, 1}};
  for (int i = 0; i < 14; ++i) asset.texels.push_back(numbers.integer(0xFFFFFFFFu));
}

/// Material 0 keeps the extension that adds nothing; the flags of material 1 are all of 1.1 that go together.
void addExtensions(Asset& asset) {
  Numbers numbers;
  asset.materialExtensions.resize(2);
  MaterialExtension& x = asset.materialExtensions[1];
  x.ior = 1.25f;
  for (float* value :
       {&x.anisotropy, &x.anisotropyRotation, &x.clearcoat, &x.clearcoatRoughness, &x.sheenRoughness,
        &x.transmission, &x.diffuseTransmission, &x.iridescence, &x.scatterAnisotropy})
    *value = numbers.fraction();
  x.clearcoatNormalScale = -3.0f;
  x.iridescenceIor = 1.75f;
  for (auto* color : {&x.sheenColor, &x.diffuseTransmissionColor, &x.emissive, &x.absorption, &x.scattering})
    numbers.fill(*color);
  x.iridescenceThickness[0] = 200.0f;
  x.iridescenceThickness[1] = 350.0f;
  uint16_t at = 0;
  for (TextureRef* reference :
       {&x.anisotropyTexture, &x.clearcoatTexture, &x.clearcoatRoughnessTexture, &x.clearcoatNormalTexture,
        &x.sheenColorTexture, &x.sheenRoughnessTexture, &x.transmissionTexture, &x.diffuseTransmissionTexture,
        &x.diffuseTransmissionColorTexture, &x.iridescenceTexture, &x.iridescenceThicknessTexture,
        &x.emissiveTexture}) {
    *reference = {at % 2u, uint16_t(at / 2 % 2), uint16_t(at / 3 % 3)};
    ++at;
  }
  asset.materials[0].flags |= kUnlit;
  asset.materials[1].flags = kAlphaBlend | kVolume | kMultipleScattering;
  asset.materials[1].normalTexture.transform = 2;
  asset.textureTransforms.resize(2);
  for (TextureTransform& transform : asset.textureTransforms)
    for (auto& row : transform.rows) numbers.fill(row);
}

void addRecords(Asset& asset, Numbers& numbers, const SampleSize& size) {
  const uint32_t side = 4 + size.records / 8;
  asset.info.atlasWidth = side + 1;
  asset.info.atlasHeight = side;
  asset.atlas.resize(size_t(side + 1) * side);
  for (uint32_t i = 0; i < size.records; ++i) {
    TexelRecord r{};
    numbers.fill(r.position);
    r.flags = i % 3 == 2 ? uint32_t(kBackSide) : 0;
    numbers.fillUnit(r.normal);
    r.material = i % 2;
    numbers.fillUnit(r.tangent);
    r.roughness = numbers.fraction();
    numbers.fill(r.f0);
    r.metallic = numbers.fraction();
    r.atlasX = i % (side + 1);
    r.atlasY = i / (side + 1);
    r.emissionSlot = kNone;
    asset.records.push_back(r);
    AtlasTexel& texel = asset.atlas[i];
    (r.flags & kBackSide ? texel.back : texel.front) = i;
  }
}

std::vector<PackedBox> makePage(Numbers& numbers, uint64_t boxes) {
  std::vector<PackedBox> page(boxes);
  for (PackedBox& box : page) {
    box.u0 = uint16_t(numbers.integer(65536));
    box.v0 = uint16_t(numbers.integer(65536));
    box.du = uint16_t(numbers.integer(65536));
    box.dv = uint16_t(numbers.integer(65536u - box.v0));
    for (uint16_t& energy : box.energy) energy = glm::packHalf1x16(0.25f * numbers.fraction());
  }
  return page;
}

/// The Lambert kernels of tile 0 and the glossy ones of all others begin with emitted radiance.
void addEmission(Sample& sample) {
  const size_t tiles = sample.asset.tiles.size();
  for (size_t i = 0; i < sample.pages.size(); ++i) {
    const auto stream = uint32_t(i / tiles), tile = uint32_t(i % tiles);
    if ((stream == sample.asset.diffuseStream()) != (tile == 0)) continue;
    std::vector<PackedBox>& page = sample.pages[i];
    for (size_t first = 0; first < page.size(); first += sample.asset.boxesPerKernel(stream, tile))
      page[first] = packEmission({100000.0f * float(first + 1), 0.5f, 0.0f});
  }
}

/// Random cells, so that no map is like another. Own numbers: the rest of the sample stays as it is.
VisibilityMap makeMap(Numbers& numbers) {
  VisibilityMap map;
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns; ++x)
      if (numbers.integer(3) != 0) map.setVisible(x, y);
  return map;
}

void splitRecords(Asset& asset) {
  Numbers numbers;
  asset.scheme = Scheme::split;
  for (size_t i = 0; i < asset.records.size(); ++i) {
    if (i % 3 == 1) continue;
    asset.records[i].flags |= kSplitLobe;
    asset.visibilityMaps.push_back(makeMap(numbers));
  }
}

/// Of split records. The sphere has another frequency than that of the views.
void addCells(Asset& asset, uint32_t viewFrequency) {
  const uint32_t f = viewFrequency == 2 ? 1 : 2;
  asset.scheme = Scheme::cells;
  asset.cellSphere = {{f, 10 * f * f + 2}};
  for (size_t i = 0; i < asset.records.size(); i += 3) asset.records[i].flags |= kDirectionCells;
}

void addCoarseViews(Asset& asset) {
  asset.coarseViews = {{2, 42}, {1, 12}};
  for (uint32_t i = 0; i < asset.records.size(); ++i) asset.records[i].flags |= i % 3 << kViewSphereShift;
}

/// The last two records move to the first coarser level of the atlas, of their sides.
void addLevel(Asset& asset) {
  const uvec2 size = asset.levelSize(1);
  asset.atlasLevels.resize(size_t(size.x) * size.y);
  for (uint32_t k = 0; k < 2; ++k) {
    const auto i = uint32_t(asset.records.size()) - 2 + k;
    asset.atlas[i] = {};
    TexelRecord& r = asset.records[i];
    r.level = 1, r.atlasX = k, r.atlasY = 0;
    (r.flags & kBackSide ? asset.atlasLevels[k].back : asset.atlasLevels[k].front) = i;
  }
}

/// Bit r: have the views of record r's sphere this number?
uint64_t recordsWithView(const Asset& asset, const Tile& tile, uint32_t view) {
  uint64_t bits = 0;
  for (uint32_t r = 0; r < tile.recordCount; ++r) {
    const uint32_t sphere = asset.viewSphere(tile.firstRecord + r);
    if (sphere == 0 || view < asset.coarseViews[sphere - 1].count) bits |= uint64_t(1) << r;
  }
  return bits;
}

uint64_t recordsWithCells(const Asset& asset, const Tile& tile) {
  uint64_t bits = 0;
  for (uint32_t r = 0; r < tile.recordCount; ++r)
    if (asset.hasCells(tile.firstRecord + r)) bits |= uint64_t(1) << r;
  return bits;
}

/// Every other record has a kernel, and bit 2; none of the tiles but the first has any in every third view.
uint64_t maskOf(const Asset& asset, uint32_t stream, uint32_t tile) {
  const uint64_t all = ~uint64_t(0) >> (64 - asset.tiles[tile].recordCount);
  if (stream == asset.diffuseStream()) return all;
  const uint64_t some = (0x5555555555555555ull << stream % 2 | 4) & all;
  const uint64_t withCells = recordsWithCells(asset, asset.tiles[tile]);
  if (stream >= asset.firstCellStream()) return some & withCells;
  if (tile > 0 && stream % 3 == 0) return 0;
  return some & ~withCells & recordsWithView(asset, asset.tiles[tile], stream);
}

/// Behind emitted radiance where a kernel has it, else in slot 0.
void addHiddenParts(Sample& sample) {
  const Asset& asset = sample.asset;
  const size_t tiles = asset.tiles.size();
  for (size_t i = 0; i < sample.pages.size(); ++i) {
    const auto stream = uint32_t(i / tiles), tile = uint32_t(i % tiles);
    if (stream == asset.diffuseStream()) continue;
    PackedBox* kernel = sample.pages[i].data();
    for (uint64_t left = asset.mask(stream, tile); left != 0; left &= left - 1) {
      const uint32_t bit = uint32_t(std::countr_zero(left));
      if (asset.isSplit(asset.tiles[tile].firstRecord + bit))
        kernel[isEmission(kernel[0]) ? 1 : 0] = packHiddenPart(float(1 + bit + stream) / 128);
      kernel += asset.boxesPerKernel(stream, tile);
    }
  }
}

/// The first of a kernel is the whole sphere, the others lie on the raster and have either sign.
void addCosineBoxes(Sample& sample) {
  const size_t tiles = sample.asset.tiles.size();
  for (size_t tile = 0; tile < tiles; ++tile) {
    std::vector<PackedBox>& page = sample.pages[sample.asset.diffuseStream() * tiles + tile];
    for (size_t slot = 0; slot < page.size(); ++slot) {
      if (isEmission(page[slot]) || slot % 2 == 0) continue;
      CosineBox cosine{{0, 0, 1, 1}, slot % 3 == 0 ? 1.0f : -0.25f};
      if (slot % 4 != 1) cosine.box = {float(slot % 64) / 64, 0.25f, 0.5f, float(1 + slot % 90) / 128};
      page[slot] = packCosineBox(cosine);
    }
  }
}

/// Tile 0 has glossy and Lambert kernels of different lengths.
void addPages(Sample& sample, Numbers& numbers, const SampleSize& size) {
  Asset& asset = sample.asset;
  const uint32_t fewest = size.split ? 4 : 2;
  for (uint32_t first = 0; first < size.records; first += size.recordsPerTile)
    asset.tiles.push_back(
        {first, std::min(size.recordsPerTile, size.records - first), first == 0 ? 3 : fewest, 4});
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile)
      asset.streamMasks.push_back(maskOf(asset, stream, tile));
  for (size_t i = 0; i < asset.streamMasks.size(); ++i) {
    const auto stream = uint32_t(i / asset.tiles.size()), tile = uint32_t(i % asset.tiles.size());
    sample.pages.push_back(makePage(
        numbers, uint64_t(std::popcount(asset.streamMasks[i])) * asset.boxesPerKernel(stream, tile)));
  }
}

}  // namespace

PageSource Sample::source() const {
  return [this](uint32_t stream, uint32_t tile) {
    return std::span<const PackedBox>(pages[size_t(stream) * asset.tiles.size() + tile]);
  };
}

Sample makeSample(SampleSize size) {
  Sample sample;
  Asset& asset = sample.asset;
  Numbers numbers;
  asset.provenance = {
      {"tool", "sample 1.0"}, {"options", {{"boxes", 3}, {"name", "J\u00e4ger"}}}, {"seed", 7}};
  asset.info.viewFrequency = size.viewFrequency;
  asset.info.viewCount = 10 * size.viewFrequency * size.viewFrequency + 2;
  addMesh(asset, numbers);
  addMaterials(asset, numbers);
  if (size.extensions) addExtensions(asset);
  addRecords(asset, numbers, size);
  if (size.split) splitRecords(asset);
  if (size.cells) addCells(asset, size.viewFrequency);
  if (size.coarse) addCoarseViews(asset), addLevel(asset);
  addPages(sample, numbers, size);
  if (size.extensions) addEmission(sample);
  if (size.split) addHiddenParts(sample);
  if (size.cosine) addCosineBoxes(sample);
  return sample;
}

}  // namespace boxlight::asset
