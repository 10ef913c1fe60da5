// SPDX-License-Identifier: Apache-2.0
// Light that moves, on the device: what a rotation, a new image and a tilt cost before the next frame can be
// drawn, uploads and waiting included. docs/numerics.md has the figures.
#include <benchmark/benchmark.h>

#include "common/light/environment_tilt.h"
#include "data/environments.h"
#include "runtime/light/light.h"
#include "tests/runtime/synthetic.h"
#include "tests/support/temporary_path.h"

namespace boxlight {
namespace {

gpu::Device& device() {
  static gpu::Device device({"", false});
  return device;
}

/// 1024 x 512.
const Image& sky() {
  static const Image image = data::makeEnvironment("sky");
  return image;
}

void build(gpu::Light& light) {
  device().run([&](gpu::Commands& commands) { light.build(commands); });
  light.show();
}

/// A new 1k environment: upload, light map of 512 x 256, table, and moments and trees where asked for.
void BM_NewEnvironment(benchmark::State& state, gpu::SatScheme scheme, gpu::SatBuild sums, bool moments,
                       bool trees = false) {
  gpu::Light light(device(), sky(), {}, {{512, 256}, scheme, sums, moments, trees});
  build(light);
  for (auto _ : state) {
    light.setEnvironment(sky());
    build(light);
  }
}
BENCHMARK_CAPTURE(BM_NewEnvironment, compact, gpu::SatScheme::compact, gpu::SatBuild::automatic, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_NewEnvironment, compact_with_moments, gpu::SatScheme::compact, gpu::SatBuild::automatic,
                  true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_NewEnvironment, compact_with_trees, gpu::SatScheme::compact, gpu::SatBuild::automatic,
                  true, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_NewEnvironment, exact, gpu::SatScheme::exact, gpu::SatBuild::automatic, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_NewEnvironment, compact_by_workgroups, gpu::SatScheme::compact, gpu::SatBuild::groups,
                  false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Pitch and roll of the same environment.
void BM_Tilt(benchmark::State& state) {
  gpu::Light light(device(), sky(), {1.0f, 1.0f}, {});
  build(light);
  float degrees = 0;
  for (auto _ : state) {
    light.setTilt({degrees += 1.0f, 20.0f});
    build(light);
  }
}
BENCHMARK(BM_Tilt)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A frame of 256 x 256 pixels and 4096 records: under a light at rest (0), and turned about +Y before each
/// frame (1).
void BM_Frame(benchmark::State& state) {
  const auto path = test::temporaryPath("light_bench.ptb");
  Square square;
  square.atlasEdge = 64;
  square.diffuseBoxes = 8;
  const auto reader = square.write(path, [](uint32_t, uint32_t record, uint32_t slot) {
    return Box{float(record % 97) / 97, float(slot) / 16, 0.2f, 0.3f, Rgb(0.1f)};
  });
  gpu::FrameSettings settings;
  settings.camera = cameraAbove(256);
  gpu::FrameRenderer renderer(device(), reader, sky(), settings);
  for (auto _ : state) {
    if (state.range(0)) {
      gpu::FrameSettings turned = renderer.settings();
      turned.environmentDegrees += 1.0f;
      renderer.set(turned);
    }
    renderer.run();
  }
  std::filesystem::remove(path);
}
BENCHMARK(BM_Frame)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace boxlight
