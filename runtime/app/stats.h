// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/app/frame.h"

namespace boxlight::gpu {

/// GPU times of repeated frames.
class FrameTimes {
 public:
  void add(const std::vector<PassTime>& frame);
  /// {"passes": [{"name", "min_ms", "median_ms"}], "frame": {"min_ms", "median_ms"}}; null where the device
  /// has no timestamps.
  nlohmann::ordered_json toJson() const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> passes_;  // [pass][frame], milliseconds
};

/// What `--stats` writes.
nlohmann::ordered_json describeFrame(const DeviceInfo& device, const FrameSettings& settings,
                                     const FrameCounts& counts, const FrameTimes& times, uint32_t frames);

}  // namespace boxlight::gpu
