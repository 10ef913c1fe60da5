// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/shade.h"

#include <array>

#include "runtime/kernels/visibility.h"
#include "spirv/resolve_comp.h"
#include "spirv/shade_comp.h"

namespace boxlight::gpu {

namespace {

bool isColored(const asset::Asset& asset) {
  return std::any_of(asset.vertices.begin(), asset.vertices.end(), [](const asset::Vertex& vertex) {
    return vertex.color[0] != 1.0f || vertex.color[1] != 1.0f || vertex.color[2] != 1.0f;
  });
}

}  // namespace

bool isGlossy(const asset::Asset& asset) {
  return std::any_of(asset.tiles.begin(), asset.tiles.end(),
                     [](const asset::Tile& tile) { return tile.glossyBoxes > 0; });
}

ShadedRecords::ShadedRecords(Device& device, Bindings& bindings, const asset::Asset& asset)
    : buffer_(device, "shaded texel records", uint64_t(2 * asset.records.size()) * sizeof(vec4)) {
  bindings.set(kBindShaded, buffer_);
}

std::vector<vec4> ShadedRecords::read(Device& device) const {
  return readBuffer<vec4>(device, buffer_, buffer_.size() / sizeof(vec4));
}

ShadePass::ShadePass(Device& device, const Bindings& bindings, const asset::Asset& asset, uint32_t poolCount,
                     Interpolation interpolation)
    : pipeline_(device, bindings, shade_comp,
                std::array<uint32_t, 3>{interpolation == Interpolation::weight, poolCount, isGlossy(asset)}) {
}

void ShadePass::shade(Commands& commands, const Buffer& list) const {
  commands.dispatchIndirect(pipeline_, list, offsetof(VisibleHeader, groups));
}

ResolvePass::ResolvePass(Device& device, Bindings& bindings, const asset::Asset& asset, uint64_t tilePixels,
                         bool background)
    : picture_(device, "picture", tilePixels * sizeof(vec4)),
      pipeline_(
          device, bindings, resolve_comp,
          std::array<uint32_t, 4>{isGlossy(asset), background, !asset.textures.empty(), isColored(asset)}) {
  bindings.set(kBindPicture, picture_);
}

void ResolvePass::resolve(Commands& commands, const ImageTile& tile) const {
  commands.dispatch(pipeline_, imageGroups(tile.size), std::as_bytes(std::span(&tile, 1)));
}

std::vector<vec4> ResolvePass::read(Device& device, const ImageTile& tile) const {
  return readBuffer<vec4>(device, picture_, size_t(tile.size.x) * tile.size.y);
}

}  // namespace boxlight::gpu
