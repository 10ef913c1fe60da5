// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/layers.h"

#include "runtime/kernels/visibility.h"
#include "spirv/layer_count_comp.h"
#include "spirv/layer_frag.h"
#include "spirv/layer_vert.h"

namespace boxlight::gpu {
namespace {

std::vector<uint32_t> blendedTriangles(const asset::Asset& asset) {
  std::vector<uint32_t> triangles;
  for (uint32_t t = 0; t < asset.triangles.size(); ++t)
    if (asset.materials[asset.triangles[t].material].flags & asset::kAlphaBlend) triangles.push_back(t);
  return triangles;
}

uint64_t area(uvec2 size) { return uint64_t(size.x) * size.y; }

Buffer makeLayers(const Device& device, uvec2 tileSamples, uint32_t limit) {
  return {device, "blended layers",
          sizeof(LayerHeader) + area(tileSamples) * LayerPass::bytesPerSample(limit)};
}

Buffer makeDepths(const Device& device, uvec2 tileSamples) {
  return {device, "depths of blended layers", area(tileSamples) * 2 * sizeof(float)};
}

std::span<const std::byte> bytesOf(const TilePush& push) { return std::as_bytes(std::span(&push, 1)); }

}  // namespace

// The layer that a sample has beyond the limit is peeled to be counted.
uint64_t LayerPass::bytesPerSample(uint32_t limit) { return uint64_t(limit + 1) * sizeof(uvec2); }

LayerPass::LayerPass(Device& device, Bindings& bindings, const asset::Asset& asset,
                     const SurfaceConstants& constants, uvec2 tileSamples, uint32_t limit)
    : limit_(limit),
      triangles_(makeBuffer(device, "blended triangles", blendedTriangles(asset))),
      layers_(makeLayers(device, tileSamples, limit)),
      depths_(makeDepths(device, tileSamples)),
      target_(device, tileSamples, {.pairs = true, .copiedDepth = true}),
      raster_(device, bindings, target_, layer_vert, layer_frag, constants, DepthTest::keepsLast),
      count_(device, bindings, layer_count_comp, constants),
      vertexCount_(uint32_t(3 * blendedTriangles(asset).size())) {
  bindings.set(kBindBlended, triangles_);
  bindings.set(kBindLayers, layers_);
  bindings.set(kBindLayerDepths, depths_);
}

void LayerPass::resize(Device& device, Bindings& bindings, uvec2 tileSamples) {
  layers_ = makeLayers(device, tileSamples, limit_);
  depths_ = makeDepths(device, tileSamples);
  target_ = RasterTarget(device, tileSamples, target_.format());
  bindings.set(kBindLayers, layers_);
  bindings.set(kBindLayerDepths, depths_);
}

void LayerPass::begin(Commands& commands, const RasterTarget& opaque, uvec2 extent) const {
  commands.copyDepth(opaque, extent, depths_, 0);
}

void LayerPass::peel(Commands& commands, const ImageTile& tile, uint32_t samples, uint32_t layer) const {
  const uvec2 extent = tile.size * samples;
  commands.draw(raster_, target_, extent, vertexCount_, bytesOf({tile, layer}));
  commands.copySamples(target_, extent, layers_, sizeof(LayerHeader) + layer * area(extent) * sizeof(uvec2));
  commands.copyDepth(target_, extent, depths_, area(extent) * sizeof(float));
}

void LayerPass::draw(Commands& commands, const RasterTarget& opaque, const ImageTile& tile, uint32_t samples,
                     uint32_t layers) const {
  if (layers == 0) return;
  begin(commands, opaque, tile.size * samples);
  for (uint32_t layer = 0; layer < layers; ++layer) peel(commands, tile, samples, layer);
}

uint64_t LayerPass::countLast(Device& device, const ImageTile& tile, uint32_t samples,
                              uint32_t layers) const {
  const LayerHeader none{};
  upload(device, layers_, std::as_bytes(std::span(&none, 1)));
  device.run([&](Commands& commands) {
    commands.dispatch(count_, imageGroups(tile.size * samples), bytesOf({tile, layers}));
  });
  return readBuffer<LayerHeader>(device, layers_, 1).front().found;
}

LayerPass::Need LayerPass::find(Device& device, const RasterTarget& opaque, const ImageTile& tile,
                                uint32_t samples) const {
  device.run([&](Commands& commands) { begin(commands, opaque, tile.size * samples); });
  for (uint32_t layer = 0; layer <= limit_; ++layer) {
    device.run([&](Commands& commands) { peel(commands, tile, samples, layer); });
    const uint64_t found = countLast(device, tile, samples, layer + 1);
    if (found == 0) return {layer, 0};
    if (layer == limit_) return {limit_, found};
  }
  return {};
}

}  // namespace boxlight::gpu
