// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "runtime/light/light_map_pass.h"
#include "runtime/light/light_table.h"
#include "runtime/light/moment_pass.h"

namespace boxlight::gpu {

struct LightSettings {
  uvec2 size{512, 256};  ///< of the light map
  SatScheme scheme = SatScheme::compact;
  SatBuild build = SatBuild::automatic;
  bool moments = false;     ///< for cosine boxes and lobes by cells
  bool lightTrees = false;  ///< with moments: for lobes by cells
};

/// A distant light on the device: environment -> light map -> summed-area table, and moments. A rotation
/// about +Y and an intensity are the reader's own (an offset and a factor) and cost nothing; another image or
/// tilt asks for a build, into a table that nobody reads yet.
class Light {
 public:
  /// `environment`: from readEnvironment. What the device cannot hold of it is averaged away, with a warning.
  Light(Device& device, const Image& environment, EnvironmentTilt tilt, const LightSettings& settings);

  void setEnvironment(const Image& environment);
  void setTilt(EnvironmentTilt tilt);
  bool needsBuild() const { return needsBuild_; }
  void build(Commands& commands) const;
  /// After the build has run: what was built is what the others return.
  void show();

  const Buffer& table() const { return table_.shown(); }
  float unit() const { return unit_; }           ///< of the table: radiance times steradian
  uvec2 size() const { return settings_.size; }  ///< of the light map
  /// Only with LightSettings::moments.
  const Buffer& moments() const { return moments_->shown(); }
  float momentUnit() const { return moments_ ? moments_->unit() : 0.0f; }
  const Buffer& image() const { return map_.image(); }
  uvec2 imageSize() const { return {image_.width, image_.height}; }
  const Buffer& map() const { return map_.map(); }

 private:
  void prepare();

  Device& device_;
  LightSettings settings_;
  Image image_;
  EnvironmentTilt tilt_;
  Bindings bindings_;
  LightMapPass map_;
  LightTable table_;
  std::optional<MomentPass> moments_;
  float unit_ = 1, nextUnit_ = 1;
  bool needsBuild_ = false;
};

}  // namespace boxlight::gpu
