// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/viewer.h"

#include <chrono>
#include <cmath>

#include "common/base/error.h"
#include "common/base/log.h"
#include "common/image/image_metrics.h"
#include "common/light/environment.h"
#include "runtime/app/camera_control.h"
#include "runtime/app/frame_plan.h"
#include "runtime/light/light_size.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kCoarsest = 8;    // a quick picture has at least 1/8 of the pixels each way
constexpr uvec2 kFirstSize{64, 64};  // of the picture that warms a renderer up

class Clock {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

double area(uvec2 size) { return double(size.x) * size.y; }

/// Follows what is measured, without jumping after a single slow frame.
void learn(double& average, double value) { average += 0.5 * (value - average); }

double relativeError(const Image& picture, const Image& reference) {
  double difference = 0, energy = 0;
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    if (i % 4 == 3) continue;  // alpha
    const double x = double(picture.pixels[i]), r = double(reference.pixels[i]);
    difference += (x - r) * (x - r);
    energy += r * r;
  }
  return energy > 0 ? std::sqrt(difference / energy) : 0.0;
}

}  // namespace

struct Viewer::Scene {
  explicit Scene(const std::filesystem::path& path) : reader(path) { reader.verifyPages(); }
  asset::AssetReader reader;
  std::optional<FrameRenderer> renderer;
};

Viewer::Viewer(Device& device, int threads) : device_(device), threads_(threads), display_(device) {
  openEnvironment({});
}

Viewer::~Viewer() = default;

const asset::Asset& Viewer::asset() const { return scene_->reader.asset(); }
const FrameCounts& Viewer::counts() const { return scene_->renderer->counts(); }

vec3 Viewer::boundsMin() const {
  const auto& low = asset().info.boundsMin;
  return {low[0], low[1], low[2]};
}

vec3 Viewer::boundsMax() const {
  const auto& high = asset().info.boundsMax;
  return {high[0], high[1], high[2]};
}

uint32_t Viewer::mostBoxes() const {
  uint32_t most = 1;
  for (const asset::Tile& tile : asset().tiles)
    most = std::max({most, uint32_t(tile.diffuseBoxes), uint32_t(tile.glossyBoxes)});
  return most;
}

void Viewer::openAsset(const std::filesystem::path& path, ViewSettings& settings) {
  auto scene = std::make_unique<Scene>(path);
  ViewSettings opened = settings;
  const auto& low = scene->reader.asset().info.boundsMin;
  const auto& high = scene->reader.asset().info.boundsMax;
  opened.camera =
      completeCamera(settings.camera, vec3(low[0], low[1], low[2]), vec3(high[0], high[1], high[2]));
  const uvec2 lightSize = chooseLightSize(scene->reader, {environment_.width, environment_.height});
  FrameSettings first = frameSettings(opened, scene->reader.asset().info, lightSize, threads_);
  first.camera.size = glm::min(first.camera.size, kFirstSize);
  scene->renderer.emplace(device_, scene->reader, environment_, first);
  settings = opened;
  scene_ = std::move(scene);
  lightSize_ = lightSize;
  wanted_ = {};
  boxError_.reset();
  referenceOf_.reset();
}

void Viewer::openEnvironment(const std::filesystem::path& path) {
  if (path.empty()) {
    environment_ = makeImage(2, 1, 3);
    std::fill(environment_.pixels.begin(), environment_.pixels.end(), 1.0f);
  } else {
    environment_ = readEnvironment(path);
  }
  if (scene_) lightSize_ = chooseLightSize(scene_->reader, {environment_.width, environment_.height});
  environmentStale_ = true;
  referenceOf_.reset();
}

FrameSettings Viewer::wantedFrame(const ViewSettings& settings) const {
  return frameSettings(settings, asset().info, lightSize_, threads_);
}

void Viewer::apply(const FrameSettings& frame) {
  const FrameSettings& now = scene_->renderer->settings();
  const bool light =
      environmentStale_ || frame.lightSize != now.lightSize || frame.satScheme != now.satScheme;
  scene_->renderer->set(frame, light ? &environment_ : nullptr);
  environmentStale_ = false;
}

uvec2 Viewer::quickSize(uvec2 size) const {
  const double scale = std::clamp(std::sqrt(kQuickMs / (quickMs_ * area(size))), 1.0 / kCoarsest, 1.0);
  return glm::max(uvec2(vec2(size) * float(scale)), 1u);
}

bool Viewer::work(const ViewSettings& settings) {
  const FrameSettings wanted = wantedFrame(settings);
  if (!(wanted == wanted_) || environmentStale_) {
    wanted_ = wanted;
    stage_ = bandMs_ * area(wanted.camera.size) < kQuickMs ? Stage::starting : Stage::quick;
  }
  switch (stage_) {
    case Stage::resting:
      return false;
    case Stage::quick:
      drawQuick();
      stage_ = Stage::measuring;
      return true;
    case Stage::measuring:
      measureError();
      stage_ = Stage::starting;
      return false;
    case Stage::starting:
      startFull();
      stage_ = Stage::resolving;
      return false;
    case Stage::resolving:
      resolveBand();
      return stage_ == Stage::resting;
  }
  return false;
}

void Viewer::finishPicture(uvec2 size) {
  display_.endPicture();
  shownSize_ = size;
  times_ = std::move(pending_);
  pending_.clear();
}

void Viewer::drawQuick() {
  FrameSettings frame = wanted_;
  frame.camera.size = quickSize(wanted_.camera.size);
  frame.samples = 1;
  const Clock clock;
  apply(frame);
  FrameRenderer& renderer = *scene_->renderer;
  pending_ = renderer.start();
  display_.beginPicture(frame.camera.size);
  for (size_t t = 0; t < renderer.tiles().size(); ++t) {
    addTimes(pending_, renderer.resolve(t));
    display_.addTile(renderer.pixels(), renderer.tiles()[t]);
  }
  finishPicture(frame.camera.size);
  learn(quickMs_, clock.milliseconds() / area(frame.camera.size));
}

/// At the size of quick pictures. The reference is kept while nothing but the boxes changes.
void Viewer::measureError() {
  boxError_.reset();
  if (wanted_.boxLimit == FrameSettings().boxLimit) return;
  FrameSettings frame = wanted_;
  frame.camera.size = quickSize(wanted_.camera.size);
  frame.background = false;
  FrameSettings all = frame;
  all.boxLimit = FrameSettings().boxLimit;
  if (referenceOf_) all.camera.size = frame.camera.size = referenceOf_->camera.size;
  if (!referenceOf_ || !(*referenceOf_ == all)) {
    all.camera.size = frame.camera.size = quickSize(wanted_.camera.size);
    apply(all);
    scene_->renderer->run();
    reference_ = scene_->renderer->picture();
    referenceOf_ = all;
  }
  apply(frame);
  scene_->renderer->run();
  const Image& picture = scene_->renderer->picture();
  boxError_ = {relativeError(picture, reference_), 0.0};
  try {
    boxError_->rmse8 = compareImages(picture, reference_).rmse8;
  } catch (const Error&) {  // no pixel shows the object
  }
}

void Viewer::startFull() {
  apply(wanted_);
  pending_ = scene_->renderer->start();
  display_.beginPicture(wanted_.camera.size);
  tile_ = 0;
  row_ = 0;
}

void Viewer::resolveBand() {
  FrameRenderer& renderer = *scene_->renderer;
  const ImageTile tile = renderer.tiles()[tile_];
  const double fitting = kSliceMs / (bandMs_ * tile.size.x) / kPixelGroup;
  const uint32_t rows = kPixelGroup * uint32_t(std::clamp(fitting, 1.0, double(tile.size.y)));
  const Clock clock;
  addTimes(pending_, renderer.resolve(tile_, row_, rows));
  const uint32_t done = std::min(rows, tile.size.y - row_);
  learn(bandMs_, clock.milliseconds() / (double(done) * tile.size.x));
  row_ += done;
  if (row_ < tile.size.y) return;
  display_.addTile(renderer.pixels(), tile);
  row_ = 0;
  if (++tile_ < renderer.tiles().size()) return;
  finishPicture(wanted_.camera.size);
  stage_ = Stage::resting;
  log().debug("picture complete: {}x{}", shownSize_.x, shownSize_.y);
}

double Viewer::fraction() const {
  if (stage_ == Stage::resting) return 1.0;
  if (stage_ != Stage::resolving) return 0.0;
  const auto& tiles = scene_->renderer->tiles();
  return (double(tile_) + double(row_) / tiles[tile_].size.y) / double(tiles.size());
}

const Image& Viewer::picture(const ViewSettings& settings) {
  apply(wantedFrame(settings));
  scene_->renderer->run();
  if (stage_ == Stage::resolving) stage_ = Stage::starting;  // what was begun is lost
  return scene_->renderer->picture();
}

}  // namespace boxlight::gpu
