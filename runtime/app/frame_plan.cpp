// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/frame_plan.h"

#include "common/light/light_domain.h"
#include "runtime/kernels/layers.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kMaxTileSamples = 4096;  // each way: 128 MiB of visibility and depth

void setLight(FrameConstants& frame, const FrameSettings& settings, const Light& light) {
  frame.lightSize = light.size();
  frame.lightUnit = light.unit() * settings.environmentIntensity;
  frame.momentUnit = light.momentUnit() * settings.environmentIntensity;
  frame.lightOffset = environmentOffset(settings.environmentDegrees);
  frame.backgroundSize = light.imageSize();
  const glm::mat3 turned(worldToEnvironment(settings.environmentTilt, settings.environmentDegrees));
  for (int k = 0; k < 3; ++k) frame.toEnvironment[k] = vec4(turned[k], 0.0f);
  frame.lightIntensity = settings.environmentIntensity;
}

}  // namespace

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

FrameConstants frameConstants(const asset::Asset& asset, const FrameSettings& settings, const Light& light) {
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
  frame.atlasLevels = asset.levelCount();
  frame.recordCount = uint32_t(asset.records.size());
  frame.tileCount = uint32_t(asset.tiles.size());
  frame.diffuseStream = asset.diffuseStream();
  const auto trianglesOf = [](uint32_t frequency) { return 20 * frequency * frequency; };
  frame.sphereTriangles[0] = trianglesOf(asset.info.viewFrequency);
  for (const asset::GeodesicSphere& cells : asset.cellSphere)
    frame.cellTriangles = trianglesOf(cells.frequency);
  uint32_t next = frame.sphereTriangles[0] + frame.cellTriangles;
  for (int s = 0; s < int(asset.coarseViews.size()); ++s) {
    frame.sphereStart[s + 1] = next;
    next += frame.sphereTriangles[s + 1] = trianglesOf(asset.coarseViews[size_t(s)].frequency);
  }
  setLight(frame, settings, light);
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

}  // namespace boxlight::gpu
