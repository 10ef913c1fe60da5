// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/settings.h"

namespace boxlight::gpu {

FrameSettings frameSettings(const ViewSettings& settings, const asset::Info& info, uvec2 lightSize,
                            int threads) {
  const auto& low = info.boundsMin;
  const auto& high = info.boundsMax;
  FrameSettings frame;
  frame.camera = makeCamera(settings.camera, vec3(low[0], low[1], low[2]), vec3(high[0], high[1], high[2]));
  frame.environmentDegrees = settings.environmentDegrees;
  frame.environmentTilt = settings.environmentTilt;
  frame.environmentIntensity = settings.environmentIntensity;
  frame.samples = settings.samples;
  if (settings.boxes > 0) frame.boxLimit = settings.boxes;
  frame.layerLimit = settings.layers;
  frame.interpolation = settings.interpolation;
  frame.lightSize = settings.lightSize.value_or(lightSize);
  frame.satScheme = settings.satScheme;
  frame.background = settings.background;
  frame.threads = threads;
  return frame;
}

}  // namespace boxlight::gpu
