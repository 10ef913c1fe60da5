// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/stats.h"

namespace boxlight::gpu {
namespace {

nlohmann::ordered_json summary(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return nullptr;
  std::sort(milliseconds.begin(), milliseconds.end());
  return {{"min_ms", milliseconds.front()}, {"median_ms", milliseconds[milliseconds.size() / 2]}};
}

}  // namespace

void FrameTimes::add(const std::vector<PassTime>& frame) {
  if (names_.empty())
    for (const PassTime& time : frame) names_.push_back(time.name);
  passes_.resize(names_.size());
  for (size_t i = 0; i < frame.size(); ++i) passes_[i].push_back(frame[i].milliseconds);
}

nlohmann::ordered_json FrameTimes::toJson() const {
  nlohmann::ordered_json passes = nlohmann::ordered_json::array();
  std::vector<double> frames(passes_.empty() ? 0 : passes_.front().size());
  for (size_t i = 0; i < names_.size(); ++i) {
    nlohmann::ordered_json pass = {{"name", names_[i]}};
    pass.update(summary(passes_[i]));
    passes.push_back(pass);
    for (size_t f = 0; f < frames.size(); ++f) frames[f] += passes_[i][f];
  }
  return {{"passes", passes}, {"frame", summary(frames)}};
}

nlohmann::ordered_json describeFrame(const DeviceInfo& device, const FrameSettings& settings,
                                     const FrameCounts& counts, const FrameTimes& times, uint32_t frames) {
  nlohmann::ordered_json stats;
  stats["device"] = {{"name", device.name}, {"driver", device.driver}, {"api", device.apiVersion}};
  stats["image"] = {settings.camera.size.x, settings.camera.size.y};
  stats["samples"] = settings.samples;
  stats["sat"] = {settings.lightSize.x, settings.lightSize.y};
  stats["sat_scheme"] = settings.satScheme == SatScheme::exact ? "exact" : "compact";
  stats["light_table_ms"] = counts.lightMilliseconds;
  stats["interpolation"] = settings.interpolation == Interpolation::energy ? "energy" : "weight";
  stats["visible_texels"] = counts.visibleRecords;
  stats["boxes_evaluated"] = counts.boxes;
  stats["pages"] = counts.pages;
  stats["page_bytes"] = counts.pageBytes;
  stats["page_wait_ms"] = counts.pageMilliseconds;
  stats["scene_bytes"] = counts.sceneBytes;
  if (counts.layers > 0) {
    stats["layers"] = counts.layers;
    stats["samples_with_cut_layers"] = counts.cutLayerSamples;
  }
  stats["frames"] = frames;
  stats["gpu"] = times.toJson();
  return stats;
}

}  // namespace boxlight::gpu
