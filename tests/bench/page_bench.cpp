// SPDX-License-Identifier: Apache-2.0
// What a moving camera waits for pages: an orbit around a baked asset, by steps of 1, 5 and 20 degrees, each
// from an empty device. docs/ptview.md has the figures.
//   page_bench ASSET.ptb [STEPS [DEVICE]]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "common/base/error.h"
#include "runtime/app/frame.h"

namespace boxlight {
namespace {

struct Wait {
  double pages, frame;  // milliseconds of wall time; a frame with its wait
};

Wait draw(gpu::FrameRenderer& renderer) {
  const auto start = std::chrono::steady_clock::now();
  renderer.run();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {renderer.counts().pageMilliseconds, time.count()};
}

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[size_t(part * double(values.size() - 1))];
}

Camera cameraAt(const asset::Asset& asset, float degrees) {
  const auto& info = asset.info;
  const vec3 low(info.boundsMin[0], info.boundsMin[1], info.boundsMin[2]),
      high(info.boundsMax[0], info.boundsMax[1], info.boundsMax[2]);
  const float angle = degrees * kPi / 180;
  CameraOptions options;
  options.eye = 0.5f * (low + high) + framingDistance(low, high, options) *
                                          glm::normalize(vec3(std::sin(angle), 0.5f, std::cos(angle)));
  return makeCamera(options, low, high);
}

void orbit(gpu::Device& device, const asset::AssetReader& reader, float step, int steps) {
  Image environment = makeImage(64, 32, 3);
  std::fill(environment.pixels.begin(), environment.pixels.end(), 1.0f);
  gpu::FrameSettings settings;
  settings.camera = cameraAt(reader.asset(), 0);
  gpu::FrameRenderer renderer(device, reader, environment, settings);
  const double first = renderer.counts().pageMilliseconds;
  std::vector<double> waits, frames;
  for (int i = 1; i <= steps; ++i) {
    settings.camera = cameraAt(reader.asset(), float(i) * step);
    renderer.set(settings);
    const Wait wait = draw(renderer);
    waits.push_back(wait.pages);
    frames.push_back(wait.frame);
  }
  fmt::print("{:>7.0f} {:>10.1f} {:>12.1f} {:>11.1f} {:>13.1f} {:>8.1f}\n", step, first, quantile(waits, 0.5),
             quantile(waits, 1), quantile(frames, 0.5), double(renderer.counts().pageBytes) / (1 << 20));
}

int bench(int argc, char** argv) {
  if (argc < 2) fail(ExitCode::usage, "give an asset: page_bench ASSET.ptb [STEPS [DEVICE]]");
  const int steps = argc > 2 ? std::max(std::atoi(argv[2]), 1) : 36;
  gpu::Device device({argc > 3 ? argv[3] : "", false});
  const asset::AssetReader reader(argv[1]);
  fmt::print("{}, 512 x 512 pixels, {} steps; milliseconds\n", device.info().name, steps);
  fmt::print("{:>7} {:>10} {:>12} {:>11} {:>13} {:>8}\n", "degrees", "first", "median wait", "worst wait",
             "median frame", "MiB");
  for (const float step : {1.0f, 5.0f, 20.0f}) orbit(device, reader, step, steps);
  return 0;
}

}  // namespace
}  // namespace boxlight

int main(int argc, char** argv) try { return boxlight::bench(argc, argv); } catch (const std::exception& e) {
  fmt::print(stderr, "page_bench: {}\n", e.what());
  return 1;
}
