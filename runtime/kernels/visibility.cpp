// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/visibility.h"

#include <array>

#include "common/base/error.h"
#include "spirv/compact_comp.h"
#include "spirv/mark_comp.h"
#include "spirv/visibility_frag.h"
#include "spirv/visibility_vert.h"

namespace boxlight::gpu {
namespace {

std::array<uint32_t, 1> rasterConstants(const asset::Asset& asset) {
  bool masked = false;
  for (const asset::Material& material : asset.materials) masked |= (material.flags & asset::kAlphaMask) != 0;
  return {masked};
}

std::span<const std::byte> bytesOf(const ImageTile& tile) { return std::as_bytes(std::span(&tile, 1)); }

uint32_t recordGroups(uint32_t records) { return (records + kGroupSize - 1) / kGroupSize; }

void requireGroups(const Device& device, uint32_t records) {
  if (recordGroups(records) > device.limits().maxWorkGroups)
    fail(ExitCode::runtime, "the asset has {} texel records; '{}' takes {} in one dispatch", records,
         device.info().name, uint64_t(device.limits().maxWorkGroups) * kGroupSize);
}

}  // namespace

uvec3 imageGroups(uvec2 size) { return {(size + kPixelGroup - 1u) / kPixelGroup, 1u}; }

VisibilityPass::VisibilityPass(Device& device, Bindings& bindings, const asset::Asset& asset,
                               uvec2 tileSamples)
    : recordCount_(uint32_t(asset.records.size())),
      vertexCount_(uint32_t(3 * asset.triangles.size())),
      marks_(device, "marks of texel records", uint64_t(recordCount_) * sizeof(uint32_t)),
      list_(device, "visible texel records",
            sizeof(VisibleHeader) + uint64_t(recordCount_) * sizeof(uint32_t)),
      target_(device, tileSamples),
      raster_(device, bindings, target_, visibility_vert, visibility_frag, rasterConstants(asset)),
      mark_(device, bindings, mark_comp),
      compact_(device, bindings, compact_comp) {
  requireGroups(device, recordCount_);
  bindings.set(kBindMarks, marks_);
  bindings.set(kBindVisible, list_);
  bindings.setVisibilityImage(target_);
}

void VisibilityPass::clear(Commands& commands) const {
  commands.fill(marks_, 0);
  commands.fill(list_, 0);
}

void VisibilityPass::draw(Commands& commands, const ImageTile& tile, uint32_t samples) const {
  commands.draw(raster_, target_, tile.size * samples, vertexCount_, bytesOf(tile));
}

void VisibilityPass::mark(Commands& commands, const ImageTile& tile) const {
  commands.dispatch(mark_, imageGroups(tile.size), bytesOf(tile));
}

void VisibilityPass::compact(Commands& commands) const {
  commands.dispatch(compact_, {std::max(recordGroups(recordCount_), 1u), 1, 1});
}

std::vector<uint32_t> VisibilityPass::readList(Device& device) const {
  const auto header = readBuffer<VisibleHeader>(device, list_, 1).front();
  auto records = readBuffer<uint32_t>(device, list_, header.count, sizeof(VisibleHeader));
  std::sort(records.begin(), records.end());
  return records;
}

}  // namespace boxlight::gpu
