// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/frame.h"

#include <optional>

#include "common/base/log.h"
#include "common/light/light_domain.h"
#include "runtime/kernels/layers.h"
#include "runtime/kernels/scene_buffers.h"
#include "runtime/kernels/shade.h"
#include "runtime/kernels/visibility.h"
#include "runtime/kernels/visibility_maps.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kMaxTileSamples = 4096;  // each way: 128 MiB of visibility and depth

/// Image tiles that cover the picture, within what the device's images and buffers hold.
std::vector<ImageTile> splitPicture(const FrameSettings& settings, const DeviceLimits& limits, bool blended) {
  const uint64_t layerBytes =
      blended ? settings.samples * settings.samples * LayerPass::bytesPerSample(settings.layerLimit) : 0;
  const uint64_t pixelBytes = std::max<uint64_t>(sizeof(vec4), layerBytes);
  const uint32_t samples = std::min(limits.maxImageSize, kMaxTileSamples) / settings.samples;
  uint32_t edge = std::min(settings.tileEdge, samples);
  while (uint64_t(edge) * edge * pixelBytes + sizeof(LayerHeader) > limits.maxStorageBufferRange) edge /= 2;
  std::vector<ImageTile> tiles;
  const uvec2 size = settings.camera.size;
  for (uint32_t y = 0; y < size.y; y += edge)
    for (uint32_t x = 0; x < size.x; x += edge)
      tiles.push_back({{x, y}, {std::min(edge, size.x - x), std::min(edge, size.y - y)}});
  return tiles;
}

void setLight(FrameConstants& frame, const FrameSettings& settings, const Light& light) {
  frame.lightSize = light.size();
  frame.lightUnit = light.unit() * settings.environmentIntensity;
  frame.lightOffset = environmentOffset(settings.environmentDegrees);
  frame.backgroundSize = light.imageSize();
  const glm::mat3 turned(worldToEnvironment(settings.environmentTilt, settings.environmentDegrees));
  for (int k = 0; k < 3; ++k) frame.toEnvironment[k] = vec4(turned[k], 0.0f);
  frame.lightIntensity = settings.environmentIntensity;
}

FrameConstants makeConstants(const asset::Asset& asset, const FrameSettings& settings) {
  const Camera& camera = settings.camera;
  const float tanY = camera.tanHalfFov, tanX = tanY * float(camera.size.x) / float(camera.size.y);
  const auto& low = asset.info.boundsMin;
  const auto& high = asset.info.boundsMax;
  const float diagonal = glm::length(vec3(high[0], high[1], high[2]) - vec3(low[0], low[1], low[2]));
  FrameConstants frame{};
  frame.eye = vec4(camera.eye, std::max(1e-4f * diagonal, 1e-6f));
  frame.right = vec4(camera.right / tanX, 0.0f);
  frame.up = vec4(camera.up / tanY, 0.0f);
  frame.forward = vec4(camera.forward, 0.0f);
  frame.rayRight = vec4(camera.right * tanX, 0.0f);
  frame.rayUp = vec4(camera.up * tanY, 0.0f);
  frame.imageSize = camera.size;
  frame.samples = settings.samples;
  frame.boxLimit = settings.boxLimit;
  frame.atlasSize = {asset.info.atlasWidth, asset.info.atlasHeight};
  frame.recordCount = uint32_t(asset.records.size());
  frame.tileCount = uint32_t(asset.tiles.size());
  frame.diffuseStream = asset.diffuseStream();
  frame.viewTriangles = 20 * asset.info.viewFrequency * asset.info.viewFrequency;
  return frame;
}

void addTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times) {
  for (const PassTime& time : times) {
    const auto same =
        std::find_if(total.begin(), total.end(), [&](const PassTime& t) { return t.name == time.name; });
    if (same == total.end())
      total.push_back(time);
    else
      same->milliseconds += time.milliseconds;
  }
}

}  // namespace

struct FrameRenderer::Parts {
  Parts(Device& gpu, const asset::AssetReader& reader, const Image& environment, const FrameSettings& chosen);
  void showLight();
  void findVisible();
  void findLayers(size_t tile);
  void drawSamples(Commands& commands, size_t tile);
  void drawTile(Commands& commands, size_t tile);
  void resolveTile(Commands& commands, size_t tile);
  void shadeRecords(Commands& commands);
  void keepTile(const ImageTile& tile);

  Device& device;
  FrameSettings settings;
  bool blended;
  std::vector<ImageTile> tiles;      // of the picture; the first is the largest
  std::vector<uint32_t> tileLayers;  // blended ones that each tile shows
  Bindings bindings;
  SceneBuffers scene;
  Light light;
  FrameConstants constantsOfFrame;
  Buffer frame;
  ShadedRecords shaded;
  SurfaceConstants constants;
  VisibilityPass visibility;
  std::optional<LayerPass> layers;
  std::optional<ResolvePass> resolve;
  std::optional<ResidentPages> pages;
  std::optional<VisibilityMaps> maps;
  std::optional<ShadePass> shade;
  FrameCounts counts;
  Image picture;
};

FrameRenderer::Parts::Parts(Device& gpu, const asset::AssetReader& reader, const Image& environment,
                            const FrameSettings& chosen)
    : device(gpu),
      settings(chosen),
      blended(isBlended(reader.asset())),
      tiles(splitPicture(settings, gpu.limits(), blended)),
      tileLayers(tiles.size()),
      bindings(gpu),
      scene(gpu, bindings, reader.asset()),
      light(gpu, environment, settings.environmentTilt, {settings.lightSize, settings.satScheme}),
      constantsOfFrame(makeConstants(reader.asset(), settings)),
      frame(gpu, "frame constants", sizeof(FrameConstants)),
      shaded(gpu, bindings, reader.asset()),
      constants(surfaceConstants(reader.asset(), settings.background, blended ? settings.layerLimit : 0)),
      visibility(gpu, bindings, reader.asset(), constants, tiles.front().size * settings.samples),
      picture(makeImage(settings.camera.size.x, settings.camera.size.y, 4)) {
  constants[kConstantExactSums] = settings.satScheme == SatScheme::exact;
  bindings.set(kBindFrame, frame);
  if (blended)
    layers.emplace(gpu, bindings, reader.asset(), constants, tiles.front().size * settings.samples,
                   settings.layerLimit);

  showLight();
  findVisible();
  const std::vector<VisibleRecord> visible = visibility.readList(gpu);
  pages.emplace(gpu, bindings, reader, visible, settings.camera.eye, settings.poolBytes, settings.threads);
  if (hasSplitLobes(reader.asset())) maps.emplace(gpu, bindings, reader.asset(), visible);
  shade.emplace(gpu, bindings, reader.asset(), pages->poolCount(), pages->emitters(), settings.interpolation,
                settings.satScheme == SatScheme::exact);
  constants[kConstantLayers] = counts.layers;
  resolve.emplace(gpu, bindings, constants, uint64_t(tiles.front().size.x) * tiles.front().size.y);
  counts.visibleRecords = visible.size();
  counts.boxes = pages->countBoxes(reader.asset(), visible, settings.boxLimit);
  counts.pages = pages->pageCount();
  counts.pageBytes = pages->bytes();
  counts.sceneBytes = scene.bytes() + (maps ? maps->bytes() : 0);
}

/// The light as it is now, built first if it has to be, for the next frame.
void FrameRenderer::Parts::showLight() {
  if (light.needsBuild()) {
    counts.lightMilliseconds = 0;
    for (const PassTime& time : device.run(
             [&](Commands& commands) { commands.pass("light table", [&] { light.build(commands); }); }))
      counts.lightMilliseconds += time.milliseconds;
    light.show();
    bindings.set(kBindSummedArea, light.table());
    if (settings.background) bindings.set(kBindBackground, light.image());
  }
  setLight(constantsOfFrame, settings, light);
  upload(device, frame, std::as_bytes(std::span(&constantsOfFrame, 1)));
}

void FrameRenderer::Parts::findVisible() {
  device.run([&](Commands& commands) { visibility.clear(commands); });
  for (size_t tile = 0; tile < tiles.size(); ++tile) {
    if (layers) findLayers(tile);
    device.run([&](Commands& commands) { drawTile(commands, tile); });
  }
  device.run([&](Commands& commands) { visibility.compact(commands); });
  if (counts.cutLayerSamples > 0)
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

void FrameRenderer::Parts::drawTile(Commands& commands, size_t tile) {
  drawSamples(commands, tile);
  commands.pass("mark", [&] { visibility.mark(commands, tiles[tile], tileLayers[tile]); });
}

void FrameRenderer::Parts::shadeRecords(Commands& commands) {
  commands.pass("compact", [&] { visibility.compact(commands); });
  commands.pass("shade", [&] { shade->shade(commands, visibility.list()); });
}

void FrameRenderer::Parts::resolveTile(Commands& commands, size_t tile) {
  if (tiles.size() > 1) drawSamples(commands, tile);  // the image holds the last tile drawn
  commands.pass("resolve", [&] { resolve->resolve(commands, tiles[tile], tileLayers[tile]); });
}

void FrameRenderer::Parts::keepTile(const ImageTile& tile) {
  const std::vector<vec4> pixels = resolve->read(device, tile);
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

std::vector<PassTime> FrameRenderer::run() {
  Parts& p = *parts_;
  std::vector<PassTime> times;
  const auto submit = [&](const auto& record) { addTimes(times, p.device.run(record)); };
  submit([&](Commands& commands) { commands.pass("clear", [&] { p.visibility.clear(commands); }); });
  for (size_t tile = 0; tile < p.tiles.size(); ++tile)
    submit([&](Commands& commands) { p.drawTile(commands, tile); });
  submit([&](Commands& commands) { p.shadeRecords(commands); });
  for (size_t tile = 0; tile < p.tiles.size(); ++tile) {
    submit([&](Commands& commands) { p.resolveTile(commands, tile); });
    p.keepTile(p.tiles[tile]);
  }
  return times;
}

const Image& FrameRenderer::picture() const { return parts_->picture; }
const FrameCounts& FrameRenderer::counts() const { return parts_->counts; }
std::vector<vec4> FrameRenderer::readShaded() const { return parts_->shaded.read(parts_->device); }
std::vector<VisibleRecord> FrameRenderer::readVisible() const {
  return parts_->visibility.readList(parts_->device);
}

const Light& FrameRenderer::light() const { return parts_->light; }

void FrameRenderer::setEnvironment(const Image& environment) {
  parts_->light.setEnvironment(environment);
  parts_->showLight();
}

void FrameRenderer::turnEnvironment(float degrees, EnvironmentTilt tilt, float intensity) {
  Parts& p = *parts_;
  p.settings.environmentDegrees = degrees;
  p.settings.environmentTilt = tilt;
  p.settings.environmentIntensity = intensity;
  p.light.setTilt(tilt);
  p.showLight();
}

}  // namespace boxlight::gpu
