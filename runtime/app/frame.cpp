// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/frame.h"

#include <cassert>
#include <chrono>
#include <optional>

#include "common/base/log.h"
#include "runtime/app/frame_plan.h"
#include "runtime/kernels/layers.h"
#include "runtime/kernels/scene_buffers.h"
#include "runtime/kernels/shade.h"
#include "runtime/kernels/visibility.h"
#include "runtime/kernels/visibility_maps.h"

namespace boxlight::gpu {
namespace {

/// Do they differ in nothing but the light, which what is visible does not depend on?
bool seesTheSame(FrameSettings before, const FrameSettings& now) {
  before.environmentDegrees = now.environmentDegrees;
  before.environmentTilt = now.environmentTilt;
  before.environmentIntensity = now.environmentIntensity;
  before.lightSize = now.lightSize;
  before.satScheme = now.satScheme;
  return before == now;
}

bool isSameView(Camera before, const Camera& now) {
  before.size = now.size;
  return before == now;
}

uint64_t area(uvec2 size) { return uint64_t(size.x) * size.y; }

}  // namespace

struct FrameRenderer::Parts {
  Parts(Device& gpu, const asset::AssetReader& assetReader, const Image& environment,
        const FrameSettings& chosen);
  void set(const FrameSettings& chosen, const Image* environment);
  void setLight(const FrameSettings& before, const Image* environment);
  void showLight();
  LightSettings lightSettings() const;
  SurfaceConstants makeConstants() const;
  void fitTiles();
  void uploadConstants();
  void makeResident();
  void compileShade();
  void findLayers(size_t tile);
  void drawSamples(Commands& commands, size_t tile);
  void markTile(size_t tile, std::vector<PassTime>& times);
  void resolveTile(Commands& commands, size_t tile, uint32_t firstRow, uint32_t rows);
  void keepTile(const ImageTile& tile);

  Device& device;
  const asset::AssetReader& reader;
  FrameSettings settings;
  bool blended;
  std::vector<ImageTile> tiles;      // of the picture; the first is the largest
  std::vector<uint32_t> tileLayers;  // blended ones that each tile shows
  uvec2 tileSamples{0};              // that the buffers of a tile hold
  bool stale = true;                 // has anything changed that what is visible depends on?
  Bindings bindings;
  SceneBuffers scene;
  std::optional<Light> light;
  Buffer frame;
  ShadedRecords shaded;
  uint32_t shadePools = 0;  // what kernels are read for: `shade`, and with direction cells `resolve`
  bool shadeEmitters = false;
  SurfaceConstants constants;
  VisibilityPass visibility;
  std::optional<LayerPass> layers;
  ResolvePass resolve;
  ResidentPages pages;
  std::optional<VisibilityMaps> maps;
  std::optional<ShadePass> shade;
  bool saidCut = false;
  FrameCounts counts;
  Image picture;
};

FrameRenderer::Parts::Parts(Device& gpu, const asset::AssetReader& assetReader, const Image& environment,
                            const FrameSettings& chosen)
    : device(gpu),
      reader(assetReader),
      settings(chosen),
      blended(isBlended(reader.asset())),
      tiles(splitPicture(settings, gpu.limits(), blended)),
      tileLayers(tiles.size()),
      tileSamples(tiles.front().size * settings.samples),
      bindings(gpu),
      scene(gpu, bindings, reader.asset()),
      frame(gpu, "frame constants", sizeof(FrameConstants)),
      shaded(gpu, bindings, reader.asset()),
      constants(makeConstants()),
      visibility(gpu, bindings, reader.asset(), constants, tileSamples),
      resolve(gpu, bindings, constants, area(tiles.front().size)),
      pages(gpu, bindings, reader, settings.poolBytes, settings.threads) {
  if (blended) layers.emplace(gpu, bindings, reader.asset(), constants, tileSamples, settings.layerLimit);
  if (hasSplitLobes(reader.asset())) maps.emplace(gpu, bindings, reader.asset());
  bindings.set(kBindFrame, frame);
  light.emplace(device, environment, settings.environmentTilt, lightSettings());
}

LightSettings FrameRenderer::Parts::lightSettings() const {
  return {.size = settings.lightSize,
          .scheme = settings.satScheme,
          .moments = needsMoments(reader.asset()),
          .lightTrees = hasSplitLobes(reader.asset())};
}

SurfaceConstants FrameRenderer::Parts::makeConstants() const {
  SurfaceConstants made = surfaceConstants(reader.asset(), blended ? settings.layerLimit : 0);
  made[kConstantExactSums] = settings.satScheme == SatScheme::exact;
  made[kConstantWeights] = settings.interpolation == Interpolation::weight;
  made[kConstantBoxPools] = std::max(shadePools, 1u);
  made[kConstantEmitters] = shadeEmitters;
  return made;
}

void FrameRenderer::Parts::setLight(const FrameSettings& before, const Image* environment) {
  const bool otherTable = settings.lightSize != before.lightSize || settings.satScheme != before.satScheme;
  if (otherTable) {
    assert(environment);
    light.emplace(device, *environment, settings.environmentTilt, lightSettings());
  } else {
    if (environment) light->setEnvironment(*environment);
    light->setTilt(settings.environmentTilt);
  }
  if (settings.satScheme == before.satScheme) return;
  constants = makeConstants();
  resolve.specialize(constants);
  shade.reset();
}

/// The light as it is now, built first if it has to be.
void FrameRenderer::Parts::showLight() {
  if (light->needsBuild()) {
    counts.lightMilliseconds = 0;
    for (const PassTime& time : device.run(
             [&](Commands& commands) { commands.pass("light table", [&] { light->build(commands); }); }))
      counts.lightMilliseconds += time.milliseconds;
    light->show();
    bindings.set(kBindSummedArea, light->table());
    if (needsMoments(reader.asset())) bindings.set(kBindMoments, light->moments());
    bindings.set(kBindBackground, light->image());
  }
  uploadConstants();
}

void FrameRenderer::Parts::set(const FrameSettings& chosen, const Image* environment) {
  const FrameSettings before = std::exchange(settings, chosen);
  if (!isSameView(before.camera, settings.camera)) counts.pageMilliseconds = 0;
  setLight(before, environment);
  if (seesTheSame(before, settings)) return;
  if (blended && settings.layerLimit != before.layerLimit) {
    constants = makeConstants();
    visibility = VisibilityPass(device, bindings, reader.asset(), constants, tileSamples);
    layers.emplace(device, bindings, reader.asset(), constants, tileSamples, settings.layerLimit);
  }
  if (settings.interpolation != before.interpolation) shade.reset();
  fitTiles();
  stale = true;
}

/// Buffers of a tile only grow, so that pictures of two sizes in turn cost nothing.
void FrameRenderer::Parts::fitTiles() {
  tiles = splitPicture(settings, device.limits(), blended);
  tileLayers.assign(tiles.size(), 0);
  const uvec2 needed = tiles.front().size * settings.samples;
  if (needed.x > tileSamples.x || needed.y > tileSamples.y) {
    tileSamples = glm::max(tileSamples, needed);
    visibility.resize(device, bindings, tileSamples);
    if (layers) layers->resize(device, bindings, tileSamples);
  }
  const uint64_t pixels = area(tiles.front().size);
  if (pixels * sizeof(vec4) > resolve.pixels().size()) resolve.resize(device, bindings, pixels);
}

void FrameRenderer::Parts::uploadConstants() {
  const FrameConstants values = frameConstants(reader.asset(), settings, *light);
  upload(device, frame, std::as_bytes(std::span(&values, 1)));
}

void FrameRenderer::Parts::compileShade() {
  const bool otherPages = shadePools != pages.poolCount() || shadeEmitters != pages.emitters();
  if (shade && !otherPages) return;
  shadePools = pages.poolCount();
  shadeEmitters = pages.emitters();
  constants = makeConstants();
  shade.emplace(device, bindings, constants);
  if (otherPages && hasDirectionCells(reader.asset())) resolve.specialize(constants);
}

void FrameRenderer::Parts::makeResident() {
  const std::vector<VisibleRecord> visible = visibility.readList(device);
  const auto start = std::chrono::steady_clock::now();
  pages.require(visible, settings.camera.eye);
  if (maps) maps->require(visible);
  counts.pageMilliseconds +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  counts.visibleRecords = visible.size();
  counts.boxes = pages.countBoxes(visible, settings.boxLimit);
  counts.pages = pages.pageCount();
  counts.pageBytes = pages.bytes();
  counts.sceneBytes = scene.bytes() + (maps ? maps->bytes() : 0);
  if (counts.cutLayerSamples > 0 && !std::exchange(saidCut, true))
    log().warn("{} samples have more than {} blended layers; the farther ones are left out: see --layers",
               counts.cutLayerSamples, settings.layerLimit);
}

void FrameRenderer::Parts::findLayers(size_t tile) {
  device.run([&](Commands& commands) { visibility.draw(commands, tiles[tile], settings.samples); });
  const auto need = layers->find(device, visibility.target(), tiles[tile], settings.samples);
  tileLayers[tile] = need.layers;
  counts.layers = std::max(counts.layers, need.layers);
  counts.cutLayerSamples += need.cutSamples;
}

void FrameRenderer::Parts::drawSamples(Commands& commands, size_t tile) {
  commands.pass("visibility", [&] { visibility.draw(commands, tiles[tile], settings.samples); });
  if (!layers) return;
  commands.pass("layers", [&] {
    layers->draw(commands, visibility.target(), tiles[tile], settings.samples, tileLayers[tile]);
  });
}

void FrameRenderer::Parts::markTile(size_t tile, std::vector<PassTime>& times) {
  if (stale && layers) findLayers(tile);
  addTimes(times, device.run([&](Commands& commands) {
    drawSamples(commands, tile);
    commands.pass("mark", [&] { visibility.mark(commands, tiles[tile], tileLayers[tile]); });
  }));
}

void FrameRenderer::Parts::resolveTile(Commands& commands, size_t tile, uint32_t firstRow, uint32_t rows) {
  if (tiles.size() > 1 && firstRow == 0) drawSamples(commands, tile);  // the image holds the last tile drawn
  rows = std::min(rows, tiles[tile].size.y - firstRow);
  commands.pass("resolve", [&] { resolve.resolve(commands, tiles[tile], tileLayers[tile], firstRow, rows); });
}

void FrameRenderer::Parts::keepTile(const ImageTile& tile) {
  const std::vector<vec4> pixels = resolve.read(device, tile);
  for (uint32_t y = 0; y < tile.size.y; ++y)
    std::copy_n(&pixels[size_t(y) * tile.size.x].x, size_t(4) * tile.size.x,
                picture.at(tile.origin.x, tile.origin.y + y));
}

FrameRenderer::FrameRenderer(Device& device, const asset::AssetReader& reader, const Image& environment,
                             const FrameSettings& settings)
    : parts_(std::make_unique<Parts>(device, reader, environment, settings)) {
  run();
}

FrameRenderer::~FrameRenderer() = default;

void FrameRenderer::set(const FrameSettings& settings, const Image* environment) {
  parts_->set(settings, environment);
}

std::vector<PassTime> FrameRenderer::start() {
  Parts& p = *parts_;
  std::vector<PassTime> times;
  const auto submit = [&](const auto& record) { addTimes(times, p.device.run(record)); };
  if (p.stale) p.counts.layers = 0, p.counts.cutLayerSamples = 0;
  p.showLight();
  submit([&](Commands& commands) { commands.pass("clear", [&] { p.visibility.clear(commands); }); });
  for (size_t tile = 0; tile < p.tiles.size(); ++tile) p.markTile(tile, times);
  submit([&](Commands& commands) { commands.pass("compact", [&] { p.visibility.compact(commands); }); });
  if (p.stale) p.makeResident();
  p.stale = false;
  p.compileShade();
  p.resolve.prepare(p.device, p.bindings, p.settings.background, p.counts.layers);
  submit([&](Commands& commands) {
    commands.pass("shade", [&] { p.shade->shade(commands, p.visibility.list()); });
  });
  return times;
}

std::vector<PassTime> FrameRenderer::resolve(size_t tile, uint32_t firstRow, uint32_t rows) {
  return parts_->device.run([&](Commands& commands) { parts_->resolveTile(commands, tile, firstRow, rows); });
}

std::vector<PassTime> FrameRenderer::run() {
  Parts& p = *parts_;
  const uvec2 size = p.settings.camera.size;
  if (p.picture.width != size.x || p.picture.height != size.y) p.picture = makeImage(size.x, size.y, 4);
  std::vector<PassTime> times = start();
  for (size_t tile = 0; tile < p.tiles.size(); ++tile) {
    addTimes(times, resolve(tile));
    p.keepTile(p.tiles[tile]);
  }
  return times;
}

const FrameSettings& FrameRenderer::settings() const { return parts_->settings; }
const std::vector<ImageTile>& FrameRenderer::tiles() const { return parts_->tiles; }
const Buffer& FrameRenderer::pixels() const { return parts_->resolve.pixels(); }
const Image& FrameRenderer::picture() const { return parts_->picture; }
const FrameCounts& FrameRenderer::counts() const { return parts_->counts; }
std::vector<vec4> FrameRenderer::readShaded() const { return parts_->shaded.read(parts_->device); }
std::vector<VisibleRecord> FrameRenderer::readVisible() const {
  return parts_->visibility.readList(parts_->device);
}

const Light& FrameRenderer::light() const { return *parts_->light; }

}  // namespace boxlight::gpu
