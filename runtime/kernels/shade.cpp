// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/shade.h"

#include "runtime/kernels/visibility.h"
#include "spirv/resolve_comp.h"
#include "spirv/shade_comp.h"

namespace boxlight::gpu {

ShadedRecords::ShadedRecords(Device& device, Bindings& bindings, const asset::Asset& asset)
    : buffer_(device, "shaded texel records",
              uint64_t(asset.records.size()) * sizeof(vec4) *
                  (kShadedRadiances + (isNormalMapped(asset) ? kShadedGradients : 0))) {
  bindings.set(kBindShaded, buffer_);
}

std::vector<vec4> ShadedRecords::read(Device& device) const {
  return readBuffer<vec4>(device, buffer_, buffer_.size() / sizeof(vec4));
}

ShadePass::ShadePass(Device& device, const Bindings& bindings, const SurfaceConstants& constants)
    : pipeline_(device, bindings, shade_comp, constants) {}

void ShadePass::shade(Commands& commands, const Buffer& list) const {
  commands.dispatchIndirect(pipeline_, list, offsetof(VisibleHeader, groups));
}

ResolvePass::ResolvePass(Device& device, Bindings& bindings, const SurfaceConstants& constants,
                         uint64_t tilePixels)
    : constants_(constants), picture_(device, "picture", tilePixels * sizeof(vec4)) {
  bindings.set(kBindPicture, picture_);
}

void ResolvePass::specialize(const SurfaceConstants& constants) {
  constants_ = constants;
  variant_.reset();
}

void ResolvePass::resize(Device& device, Bindings& bindings, uint64_t tilePixels) {
  picture_ = Buffer(device, "picture", tilePixels * sizeof(vec4));
  bindings.set(kBindPicture, picture_);
}

void ResolvePass::prepare(const Device& device, const Bindings& bindings, bool background, uint32_t layers) {
  const bool fits = variant_ && variant_->background == background;
  if (fits && variant_->layers >= layers) return;  // fewer are drawn by it, too
  constants_[kConstantBackground] = background;
  constants_[kConstantLayers] = layers;
  variant_.emplace(Variant{background, layers, {device, bindings, resolve_comp, constants_}});
}

void ResolvePass::resolve(Commands& commands, const ImageTile& tile, uint32_t layers, uint32_t firstRow,
                          uint32_t rows) const {
  const TilePush push{tile, layers, firstRow};
  commands.dispatch(variant_->pipeline, imageGroups({tile.size.x, rows}), std::as_bytes(std::span(&push, 1)));
}

std::vector<vec4> ResolvePass::read(Device& device, const ImageTile& tile) const {
  return readBuffer<vec4>(device, picture_, size_t(tile.size.x) * tile.size.y);
}

}  // namespace boxlight::gpu
