// SPDX-License-Identifier: Apache-2.0
// Fits per second of one core (items_per_second), over texels from mirror-like to rough; and matches of whole
// texels.
#include <benchmark/benchmark.h>

#include "bake/kernels/box_fit.h"
#include "bake/kernels/box_match.h"
#include "tests/support/kernel_lab.h"

namespace boxlight {
namespace {

std::vector<Deposit> sampleKernel(uint64_t seed, int paths) {
  constexpr float kAlphas[] = {0.02f, 0.1f, 0.3f, 1.0f};
  lab::Random random(seed);
  const lab::GlossyTexel texel(seed, kAlphas[seed % 4]);
  return texel.trace(texel.anyView(0.2f, random), paths, random);
}

void boxFit(benchmark::State& state) {
  const int paths = int(state.range(1));
  std::vector<std::vector<Deposit>> kernels;
  for (uint64_t seed = 0; seed < 64; ++seed) kernels.push_back(sampleKernel(seed, paths));
  BoxFitter fitter({.boxes = int(state.range(0)), .gridSize = int(state.range(2))});
  size_t next = 0;
  for (auto unused : state)
    benchmark::DoNotOptimize(fitter.fit(kernels[next++ % kernels.size()], uint64_t(paths)));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(boxFit)
    ->ArgNames({"boxes", "paths", "grid"})
    ->ArgsProduct({{4, 8, 16, 32}, {256, 1024}, {32}})
    ->Args({8, 256, 24});

void slotMatch(benchmark::State& state) {
  constexpr int kPaths = 256;
  const int slots = int(state.range(0));
  const ViewSphere sphere(3);
  const lab::GlossyTexel texel(1, 0.2f);
  const auto stored = viewsOfHemisphere(sphere, texel.normal());
  lab::Random random(1);
  BoxFitter fitter({.boxes = slots});
  std::vector<std::vector<Box>> kernels(sphere.viewCount());
  for (uint32_t view = 0; view < sphere.viewCount(); ++view) {
    const vec3 eye = raiseAboveHorizon(sphere.directions()[view], texel.normal());
    if (stored[view]) kernels[view] = fitter.fit(texel.trace(eye, kPaths, random), kPaths);
  }
  for (auto unused : state) {
    auto matched = kernels;
    matchSlots(sphere, texel.normal(), matched, slots);
    benchmark::DoNotOptimize(matched);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(slotMatch)->ArgName("slots")->Arg(8)->Arg(32)->Arg(64)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace boxlight
