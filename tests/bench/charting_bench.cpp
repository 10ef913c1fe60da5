// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>

#include "bake/scene/charting.h"
#include "bake/scene/texels.h"
#include "tests/support/meshes.h"
#include "tests/support/scenes.h"

// charting_bench --benchmark_filter=1000000: a million triangles in under two minutes is what docs/ptbake.md
// promises.

using namespace boxlight;

namespace {

/// A torus with dents and bumps, `triangles` in all.
void bumpyTorus(Scene& scene, uint32_t triangles) {
  const auto side = uint32_t(std::sqrt(double(triangles) / 2));
  test::addSurface(scene, uvec2(side), [](vec2 uv) {
    const float a = 2 * kPi * uv.x, b = 2 * kPi * uv.y;
    const float tube = 0.4f + 0.03f * std::sin(23 * a) * std::sin(17 * b), r = 1 + tube * std::cos(b);
    return vec3(r * std::cos(a), tube * std::sin(b), -r * std::sin(a));
  });
}

/// Two triangles a leaf.
void leaves(Scene& scene, uint32_t triangles) { test::addLeaves(scene, triangles / 2, 0.01f); }

void chart(benchmark::State& state, void (*build)(Scene&, uint32_t)) {
  Scene scene = test::makeScene(test::lambert());
  build(scene, uint32_t(state.range(0)));
  for (auto _ : state) {
    Scene charted = scene;
    const Charting charting = chartScene(charted, 512, ProgressStyle::none);
    state.counters["charts"] = charting.charts;
    state.counters["texels/m"] = charting.texelsPerMetre;
    benchmark::DoNotOptimize(charted.vertices.data());
  }
}

BENCHMARK_CAPTURE(chart, bumpyTorus, bumpyTorus)->Arg(10000)->Arg(1000000)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(chart, leaves, leaves)->Arg(10000)->Arg(1000000)->Unit(benchmark::kSecond);

}  // namespace
