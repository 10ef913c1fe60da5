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

namespace {

/// Of shade.comp, which does not look at surfaces and numbers its own.
SurfaceConstants shadeConstants(const asset::Asset& asset, uint32_t poolCount, bool emitters,
                                Interpolation interpolation, bool exactSums) {
  SurfaceConstants constants{interpolation == Interpolation::weight,
                             poolCount,
                             isGlossy(asset),
                             emitters,
                             isNormalMapped(asset),
                             hasSplitLobes(asset)};
  constants[kConstantExactSums] = exactSums;
  return constants;
}

}  // namespace

ShadePass::ShadePass(Device& device, const Bindings& bindings, const asset::Asset& asset, uint32_t poolCount,
                     bool emitters, Interpolation interpolation, bool exactSums)
    : pipeline_(device, bindings, shade_comp,
                shadeConstants(asset, poolCount, emitters, interpolation, exactSums)) {}

void ShadePass::shade(Commands& commands, const Buffer& list) const {
  commands.dispatchIndirect(pipeline_, list, offsetof(VisibleHeader, groups));
}

ResolvePass::ResolvePass(Device& device, Bindings& bindings, const SurfaceConstants& constants,
                         uint64_t tilePixels)
    : picture_(device, "picture", tilePixels * sizeof(vec4)),
      pipeline_(device, bindings, resolve_comp, constants) {
  bindings.set(kBindPicture, picture_);
}

void ResolvePass::resolve(Commands& commands, const ImageTile& tile, uint32_t layers) const {
  const TilePush push{tile, layers};
  commands.dispatch(pipeline_, imageGroups(tile.size), std::as_bytes(std::span(&push, 1)));
}

std::vector<vec4> ResolvePass::read(Device& device, const ImageTile& tile) const {
  return readBuffer<vec4>(device, picture_, size_t(tile.size.x) * tile.size.y);
}

}  // namespace boxlight::gpu
