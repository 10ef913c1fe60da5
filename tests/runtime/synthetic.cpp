// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/synthetic.h"

#include <random>

#include "common/asset/asset_writer.h"
#include "common/light/light_domain.h"
#include "common/light/view_sphere.h"
#include "tests/support/temporary_path.h"

namespace boxlight {
namespace {

asset::Vertex corner(float x, float z) {
  asset::Vertex vertex{};
  vertex.position[0] = x;
  vertex.position[2] = z;
  vertex.normal[1] = 1;
  vertex.tangent[0] = 1;
  vertex.tangent[3] = -1;  // bitangent +Z = -cross(+Y, +X)... of glTF's uv, which runs down with z
  for (auto* uv : {vertex.atlasUv, vertex.uv[0], vertex.uv[1]})
    uv[0] = 0.5f * (x + 1), uv[1] = 0.5f * (z + 1);
  for (float& c : vertex.color) c = 1;
  return vertex;
}

asset::TexelRecord record(uint32_t x, uint32_t y, uint32_t edge, bool back) {
  asset::TexelRecord r{};
  r.position[0] = 2 * (float(x) + 0.5f) / float(edge) - 1;
  r.position[2] = 2 * (float(y) + 0.5f) / float(edge) - 1;
  r.flags = back ? uint32_t(asset::kBackSide) : 0u;
  r.normal[1] = back ? -1.0f : 1.0f;
  r.tangent[0] = 1;
  r.roughness = 1;
  r.atlasX = x;
  r.atlasY = y;
  r.emissionSlot = asset::kNone;
  return r;
}

void addCells(asset::Asset& asset, uint32_t edge) {
  for (uint32_t cell = 0; cell < edge * edge; ++cell) {
    const float size = 2.0f / float(edge), x = -1 + size * float(cell % edge),
                z = -1 + size * float(cell / edge);
    const auto first = uint32_t(asset.vertices.size());
    for (const auto& vertex :
         {corner(x, z), corner(x + size, z), corner(x + size, z + size), corner(x, z + size)})
      asset.vertices.push_back(vertex);
    asset.triangles.push_back({{first, first + 2, first + 1}, cell});
    asset.triangles.push_back({{first, first + 3, first + 2}, cell});
  }
}

}  // namespace

void tileRecords(asset::Asset& asset, uint32_t glossyBoxes, uint32_t diffuseBoxes) {
  asset.tiles.clear();
  for (uint32_t first = 0; first < asset.records.size(); first += asset::kTileRecords)
    asset.tiles.push_back({first, std::min(asset::kTileRecords, uint32_t(asset.records.size()) - first),
                           glossyBoxes, diffuseBoxes});
  const ViewSphere sphere(asset.info.viewFrequency);
  asset.streamMasks.assign(asset.streamCount() * asset.tiles.size(), 0);
  for (size_t t = 0; t < asset.tiles.size(); ++t)
    for (uint32_t slot = 0; slot < asset.tiles[t].recordCount; ++slot) {
      const auto& n = asset.records[asset.tiles[t].firstRecord + slot].normal;
      const auto needed = viewsOfHemisphere(sphere, vec3(n[0], n[1], n[2]));
      const auto hasKernel = [&](uint32_t stream) {
        return asset.cellCount() > 0 ? stream >= asset.firstCellStream() : needed[stream];
      };
      for (uint32_t s = 0; s < asset.streamCount(); ++s)
        if (s == asset.diffuseStream() ? diffuseBoxes > 0 : glossyBoxes > 0 && hasKernel(s))
          asset.streamMasks[s * asset.tiles.size() + t] |= uint64_t(1) << slot;
    }
}

Square::Square() {
  material.metallic = 0;
  material.specular = 0;
}

asset::Asset Square::makeAsset() const {
  asset::Asset asset;
  asset.provenance = {{"tool", "runtime_test"}};
  asset.info.atlasWidth = asset.info.atlasHeight = atlasEdge;
  asset.info.viewFrequency = viewFrequency;
  asset.info.viewCount = 10 * viewFrequency * viewFrequency + 2;
  asset.info.boundsMin[0] = asset.info.boundsMin[2] = -1;
  asset.info.boundsMax[0] = asset.info.boundsMax[2] = 1;
  addCells(asset, cellEdge);
  asset.materials = cells.empty() ? std::vector{material} : cells;
  asset.materialExtensions = extensions;
  asset.textureTransforms = transforms;
  asset.textures = textures;
  asset.texels = texels;
  const uint32_t count = atlasEdge * atlasEdge;
  for (const bool back : {false, true})
    for (uint32_t i = 0; i < count && (twoSided || !back); ++i)
      asset.records.push_back(record(i % atlasEdge, i / atlasEdge, atlasEdge, back));
  for (uint32_t i = 0; i < count; ++i) asset.atlas.push_back({i, twoSided ? count + i : asset::kNone});
  if (directionCells > 0) asset.cellSphere = {{directionCells, 10 * directionCells * directionCells + 2}};
  tileRecords(asset, glossyBoxes, diffuseBoxes);
  if (!visibility) return asset;
  asset.scheme = directionCells > 0 ? asset::Scheme::cells : asset::Scheme::split;
  for (uint32_t r = 0; r < asset.records.size(); ++r) {
    asset.records[r].flags |=
        asset::kSplitLobe | (directionCells > 0 ? uint32_t(asset::kDirectionCells) : 0u);
    asset.visibilityMaps.push_back(visibility(r));
  }
  return asset;
}

asset::AssetReader Square::write(const std::filesystem::path& path, const KernelSource& kernel) const {
  return writeSynthetic(path, makeAsset(), [&](uint32_t stream, uint32_t record, uint32_t slot) {
    return packBox(kernel(stream, record, slot));
  });
}

asset::AssetReader writeSynthetic(const std::filesystem::path& path, const asset::Asset& asset,
                                  const PackedSource& kernel) {
  std::vector<PackedBox> page;
  asset::writeAsset(path, asset, [&](uint32_t stream, uint32_t t) -> std::span<const PackedBox> {
    page.clear();
    const asset::Tile& tile = asset.tiles[t];
    for (uint32_t slot = 0; slot < tile.recordCount; ++slot)
      for (uint32_t j = 0; (asset.mask(stream, t) >> slot & 1) && j < asset.boxesPerKernel(stream, t); ++j)
        page.push_back(kernel(stream, tile.firstRecord + slot, j));
    return page;
  });
  return asset::AssetReader(path);
}

void GpuTest::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = test::temporaryPath(std::string("runtime-") + info->name());
  std::filesystem::create_directories(folder_);
  device_ = std::make_unique<gpu::Device>(gpu::DeviceOptions{"", true});
}

void GpuTest::TearDown() {
  const auto log = device_->validationLog();
  device_.reset();
  EXPECT_NO_THROW(gpu::requireSilence(*log));
  std::filesystem::remove_all(folder_);
}

std::filesystem::path GpuTest::file(const char* name) const { return folder_ / name; }

Image noisyMap(uvec2 size, float sun) {
  Image map = makeImage(size.x, size.y, 3);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 2.0f);
  for (float& value : map.pixels) value = uniform(random);
  for (int c = 0; c < 3; ++c) map.at(size.x / 3, size.y / 4)[c] = sun;
  return map;
}

Image constantEnvironment(uvec2 size, Rgb radiance) {
  Image image = makeImage(size.x, size.y, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = radiance[int(i % 3)];
  return image;
}

Rgb axesColor(vec3 d) {
  const vec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0 ? Rgb(1, 0, 0) : Rgb(0, 1, 0);
  if (a.y >= a.z) return d.y > 0 ? Rgb(0, 0, 1) : Rgb(1, 1, 0);
  return d.z > 0 ? Rgb(1, 0, 1) : Rgb(0, 1, 1);
}

Image axesEnvironment(uvec2 size) {
  Image image = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x) {
      const Rgb color = axesColor(uvToDirection((vec2(x, y) + 0.5f) / vec2(size)));
      std::copy_n(&color.x, 3, image.at(x, y));
    }
  return image;
}

Camera cameraAbove(uint32_t edge) {
  Camera camera;
  camera.eye = {0, 10, 0};
  camera.forward = {0, -1, 0};
  camera.right = {1, 0, 0};
  camera.up = {0, 0, -1};
  camera.tanHalfFov = 0.1f;
  camera.size = uvec2(edge);
  return camera;
}

}  // namespace boxlight
