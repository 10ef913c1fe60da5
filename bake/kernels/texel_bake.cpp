// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/texel_bake.h"

#include "bake/kernels/box_match.h"

namespace boxlight {
namespace {

constexpr uint32_t kBackStreams = 0x10000u;  ///< added to a stream's number on the back side of a texel

std::vector<PackedBox> pack(const std::vector<Box>& boxes, size_t count) {
  std::vector<PackedBox> packed(count);
  for (size_t j = 0; j < boxes.size(); ++j) packed[j] = packBox(boxes[j]);
  return packed;
}

}  // namespace

TexelBaker::TexelBaker(const Intersector& world, const TexelMap& map, const ViewSphere& sphere,
                       const KernelOptions& options)
    : world_(world),
      map_(map),
      sphere_(sphere),
      options_(options),
      tracer_(world, options.limits),
      lambertFitter_(FitOptions{.boxes = int(options.lambertBoxes()), .gridSize = 64}),
      glossyFitter_(FitOptions{.boxes = int(KernelOptions::kMaxFittedBoxes)}) {
  key_.seed = options.seed;
}

std::vector<Box> TexelBaker::fit(BoxFitter& fitter, uint32_t boxes, RecordKernels& result) {
  for (const Deposit& deposit : paths_.deposits) result.energy += double(luminance(deposit.throughput));
  result.removed += paths_.removed;
  return paths_.traced ? fitter.fit(paths_.deposits, paths_.traced, int(boxes)) : std::vector<Box>{};
}

void TexelBaker::bakeLambert(const PathOrigin& origin, uint32_t stream, RecordKernels& result) {
  paths_.clear();
  key_.stream = stream;
  tracer_.traceLambert(origin, key_, options_.lambertPaths(), paths_);
  const std::vector<Box> boxes = fit(lambertFitter_, options_.lambertBoxes(), result);
  result.lambert.emission = paths_.emission();
  if (!boxes.empty() || maxComponent(result.lambert.emission) > 0.0f)
    result.lambert.boxes = pack(boxes, options_.lambertBoxes());
}

void TexelBaker::bakeGlossy(const PathOrigin& origin, uint32_t firstStream, uint32_t glossyLobes,
                            RecordKernels& result) {
  const std::vector<bool> stored = viewsOfHemisphere(sphere_, origin.normal);
  const uint32_t slots = options_.glossyBoxes(glossyLobes);
  std::vector<std::vector<Box>> kernels(sphere_.viewCount());
  std::vector<Rgb> emission(sphere_.viewCount(), Rgb(0.0f));
  bool anyLight = false;
  for (uint32_t view = 0; view < sphere_.viewCount(); ++view) {
    if (!stored[view]) continue;
    paths_.clear();
    key_.stream = firstStream + view;
    const vec3 wo = raiseAboveHorizon(sphere_.directions()[view], origin.normal);
    tracer_.traceGlossy(origin, wo, key_, options_.glossyPaths(glossyLobes), paths_);
    kernels[view] = fit(glossyFitter_, slots, result);
    emission[view] = paths_.emission();
    anyLight |= !kernels[view].empty() || maxComponent(emission[view]) > 0.0f;
    // A view that no light reaches is stored as such: a view that is not stored would be left out of the
    // interpolation.
    if (kernels[view].empty()) kernels[view].push_back({0, 0, 1, 1, Rgb(0.0f)});
  }
  if (!anyLight) return;
  matchSlots(sphere_, origin.normal, kernels, int(slots));
  result.glossy.resize(kernels.size());
  for (uint32_t view = 0; view < kernels.size(); ++view)
    if (stored[view]) result.glossy[view] = {pack(kernels[view], slots), emission[view]};
}

RecordKernels TexelBaker::bake(const RecordPlan& plan, uint32_t glossyLobes) {
  const PathOrigin origin = plan.origin(world_, map_);
  const uint32_t side = origin.back ? kBackStreams : 0u;
  key_.texel = plan.record.atlasY * map_.width + plan.record.atlasX;
  RecordKernels result;
  if (plan.lambert) bakeLambert(origin, side + sphere_.viewCount(), result);
  if (plan.glossy) bakeGlossy(origin, side, glossyLobes, result);
  return result;
}

}  // namespace boxlight
