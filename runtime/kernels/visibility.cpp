// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/visibility.h"

#include "common/base/error.h"
#include "spirv/compact_comp.h"
#include "spirv/mark_comp.h"
#include "spirv/visibility_frag.h"
#include "spirv/visibility_vert.h"

namespace boxlight::gpu {
namespace {

std::span<const std::byte> bytesOf(const TilePush& push) { return std::as_bytes(std::span(&push, 1)); }

uint32_t recordGroups(uint32_t records) { return (records + kGroupSize - 1) / kGroupSize; }

void requireGroups(const Device& device, uint32_t records) {
  if (recordGroups(records) > device.limits().maxWorkGroups)
    fail(ExitCode::runtime, "the asset has {} texel records; '{}' takes {} in one dispatch", records,
         device.info().name, uint64_t(device.limits().maxWorkGroups) * kGroupSize);
}

}  // namespace

uvec3 imageGroups(uvec2 size) { return {(size + kPixelGroup - 1u) / kPixelGroup, 1u}; }

VisibilityPass::VisibilityPass(Device& device, Bindings& bindings, const asset::Asset& asset,
                               const SurfaceConstants& constants, uvec2 tileSamples)
    : recordCount_(uint32_t(asset.records.size())),
      vertexCount_(uint32_t(3 * asset.triangles.size())),
      marks_(device, "marks of texel records", uint64_t(recordCount_) * sizeof(uint32_t)),
      list_(device, "visible texel records",
            sizeof(VisibleHeader) + uint64_t(recordCount_) * sizeof(uint32_t)),
      target_(device, tileSamples, {.copiedDepth = isBlended(asset)}),
      raster_(device, bindings, target_, visibility_vert, visibility_frag, constants),
      mark_(device, bindings, mark_comp, constants),
      compact_(device, bindings, compact_comp) {
  requireGroups(device, recordCount_);
  bindings.set(kBindMarks, marks_);
  bindings.set(kBindVisible, list_);
  bindings.setVisibilityImage(target_);
}

void VisibilityPass::resize(Device& device, Bindings& bindings, uvec2 tileSamples) {
  target_ = RasterTarget(device, tileSamples, target_.format());
  bindings.setVisibilityImage(target_);
}

void VisibilityPass::clear(Commands& commands) const {
  commands.fill(marks_, 0);
  commands.fill(list_, 0);
}

void VisibilityPass::draw(Commands& commands, const ImageTile& tile, uint32_t samples) const {
  commands.draw(raster_, target_, tile.size * samples, vertexCount_, bytesOf({tile, 0}));
}

void VisibilityPass::mark(Commands& commands, const ImageTile& tile, uint32_t layers) const {
  commands.dispatch(mark_, imageGroups(tile.size), bytesOf({tile, layers}));
}

void VisibilityPass::compact(Commands& commands) const {
  commands.dispatch(compact_, {std::max(recordGroups(recordCount_), 1u), 1, 1});
}

std::vector<VisibleRecord> VisibilityPass::readList(Device& device) const {
  const auto header = readBuffer<VisibleHeader>(device, list_, 1).front();
  std::vector<VisibleRecord> records;
  for (const uint32_t entry : readBuffer<uint32_t>(device, list_, header.count, sizeof(VisibleHeader)))
    records.push_back({entry & ~kLambertOnly, (entry & kLambertOnly) == 0});
  std::sort(records.begin(), records.end(),
            [](const VisibleRecord& a, const VisibleRecord& b) { return a.record < b.record; });
  return records;
}

}  // namespace boxlight::gpu
