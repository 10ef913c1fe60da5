// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/scene_buffers.h"

#include <cassert>
#include <cmath>

#include "common/image/image.h"
#include "common/light/directional_albedo.h"
#include "common/light/lobe_boxes.h"
#include "common/light/sheen.h"
#include "common/light/view_sphere.h"
#include "runtime/kernels/surface_constants.h"
#include "runtime/kernels/texture_mips.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

std::vector<GpuRecord> makeRecords(const asset::Asset& asset) {
  std::vector<GpuRecord> records(asset.records.size());
  for (uint32_t t = 0; t < asset.tiles.size(); ++t)
    for (uint32_t slot = 0; slot < asset.tiles[t].recordCount; ++slot) {
      const uint32_t r = asset.tiles[t].firstRecord + slot;
      const auto& p = asset.records[r].position;
      const auto& n = asset.records[r].normal;
      const uint32_t flags = (asset.hasCells(r) ? kRecordHasCells : 0) | asset.viewSphere(r)
                                                                             << kRecordSphereShift;
      records[r] = {{p[0], p[1], p[2]}, t, {n[0], n[1], n[2]}, slot | flags};
    }
  return records;
}

std::vector<ViewTriangle> trianglesOf(const ViewSphere& sphere) {
  std::vector<ViewTriangle> triangles(sphere.triangles().size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    const uvec3 corners = sphere.triangles()[t];
    for (int k = 0; k < 3; ++k) {
      const vec3 next = sphere.directions()[corners[(k + 1) % 3]],
                 last = sphere.directions()[corners[(k + 2) % 3]];
      triangles[t].rows[k] = vec4(glm::cross(next, last), 0.0f);
    }
    triangles[t].view = uvec4(corners, 0);
    triangles[t].neighbour = uvec4(sphere.neighbours()[t], 0);
  }
  return triangles;
}

std::vector<ViewTriangle> makeViewTriangles(const asset::Asset& asset) {
  std::vector<ViewTriangle> triangles = trianglesOf(ViewSphere(asset.info.viewFrequency));
  for (const auto* spheres : {&asset.cellSphere, &asset.coarseViews})
    for (const asset::GeodesicSphere& sphere : *spheres)
      for (const ViewTriangle& triangle : trianglesOf(ViewSphere(sphere.frequency)))
        triangles.push_back(triangle);
  return triangles;
}

void addLobeCells(std::vector<float>& tables, const LobeCells& cells) {
  static_assert(boxlight::kLobeBoxes == kLobeBoxes && boxlight::kLobeSamples == kLobeSamples);
  for (const LobeCell& cell : cells) {
    tables.insert(tables.end(), {cell.area, cell.spread});
    for (const vec2 random : cell.random) {
      const float phi = 2 * kPi * random.x;
      tables.insert(tables.end(), {std::cos(phi), std::sin(phi), 1 - random.y});
    }
  }
}

std::vector<float> makeTables(bool sheen) {
  static_assert(AlbedoTable::kSize == kAlbedoNodes);
  std::vector<float> tables;
  for (const vec2 node : albedoTable().specularNodes) tables.insert(tables.end(), {node.x, node.y});
  const auto& fresnel = albedoTable().fresnelNodes;
  tables.insert(tables.end(), fresnel.begin(), fresnel.end());
  for (int code = 0; code < 256; ++code) tables.push_back(decodeSrgb(float(code) / 255.0f));
  assert(tables.size() == kTableRoundCells);
  addLobeCells(tables, roundCells());
  assert(tables.size() == kTableStripCells);
  addLobeCells(tables, stripCells());
  assert(tables.size() == kTableSheen);
  if (sheen) tables.insert(tables.end(), sheen::albedoNodes().begin(), sheen::albedoNodes().end());
  return tables;
}

}  // namespace

SceneBuffers::SceneBuffers(Device& device, Bindings& bindings, const asset::Asset& asset) {
  const auto add = [&](uint32_t binding, const char* name, const auto& values) {
    buffers_.push_back(makeBuffer(device, name, values));
    bindings.set(binding, buffers_.back());
  };
  add(kBindVertices, "vertices", asset.vertices);
  add(kBindTriangles, "triangles", asset.triangles);
  add(kBindMaterials, "materials", asset.materials);
  if (!asset.materialExtensions.empty())
    add(kBindMaterialExtensions, "material extensions", asset.materialExtensions);
  if (!asset.textureTransforms.empty())
    add(kBindTextureTransforms, "texture transforms", asset.textureTransforms);
  if (!asset.textures.empty()) {
    const TextureSet textures = makeTextureSet(asset);
    add(kBindTextures, "texture headers", textures.headers);
    add(kBindTextureLevels, "texture levels", textures.levels);
    add(kBindTexels, "texture texels", textures.texels);
  }
  std::vector<asset::AtlasTexel> atlas = asset.atlas;
  atlas.insert(atlas.end(), asset.atlasLevels.begin(), asset.atlasLevels.end());
  add(kBindAtlas, "atlas", atlas);
  add(kBindRecords, "texel records", makeRecords(asset));
  add(kBindTiles, "tiles", asset.tiles);
  add(kBindViews, "view triangles", makeViewTriangles(asset));
  add(kBindTables, "tables", makeTables(hasSheen(asset)));
}

uint64_t SceneBuffers::bytes() const {
  uint64_t total = 0;
  for (const Buffer& buffer : buffers_) total += buffer.size();
  return total;
}

}  // namespace boxlight::gpu
