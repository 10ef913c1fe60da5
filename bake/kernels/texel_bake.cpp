// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/texel_bake.h"

#include "bake/kernels/box_match.h"
#include "bake/kernels/visibility_trace.h"

namespace boxlight {
namespace {

constexpr uint32_t kBackStreams = 0x10000u;  ///< added to a stream's number on the back side of a texel
constexpr uint32_t kMapStream = 0x8000u;     ///< apart from every view's

/// The first of an origin's streams of random numbers.
uint32_t streamsOf(const PathOrigin& origin) { return origin.back ? kBackStreams : 0u; }

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

void TexelBaker::account(RecordKernels& result) const {
  for (const Deposit& deposit : paths_.deposits) result.energy += double(luminance(deposit.throughput));
  result.removed += paths_.removed;
}

std::vector<Box> TexelBaker::fit(BoxFitter& fitter, uint32_t boxes) const {
  return paths_.traced ? fitter.fit(paths_.deposits, paths_.traced, int(boxes)) : std::vector<Box>{};
}

void TexelBaker::traceLambert(const PathOrigin& origin, RecordKernels& result) {
  paths_.clear();
  key_.stream = streamsOf(origin) + sphere_.viewCount();
  tracer_.traceLambert(origin, key_, options_.lambertPaths(), paths_);
  account(result);
}

void TexelBaker::bakeLambert(const PathOrigin& origin, RecordKernels& result) {
  traceLambert(origin, result);
  const std::vector<Box> boxes = fit(lambertFitter_, options_.lambertBoxes());
  result.lambert.emission = paths_.emission();
  if (!boxes.empty() || maxComponent(result.lambert.emission) > 0.0f)
    result.lambert.slots = pack(boxes, options_.lambertBoxes());
}

void TexelBaker::traceView(const PathOrigin& origin, uint32_t view, const GlossyKernels& kernels,
                           RecordKernels& result) {
  paths_.clear();
  key_.stream = kernels.firstStream + view;
  const vec3 wo = raiseAboveHorizon(sphere_.directions()[view], origin.normal);
  tracer_.traceGlossy(origin, wo, key_, kernels.paths, paths_);
  account(result);
}

void TexelBaker::bakeWhole(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result) {
  const std::vector<bool> stored = viewsOfHemisphere(sphere_, origin.normal);
  std::vector<std::vector<Box>> boxes(sphere_.viewCount());
  std::vector<Rgb> emission(sphere_.viewCount(), Rgb(0.0f));
  bool anyLight = false;
  for (uint32_t view = 0; view < sphere_.viewCount(); ++view) {
    if (!stored[view]) continue;
    traceView(origin, view, kernels, result);
    boxes[view] = fit(glossyFitter_, kernels.slots);
    emission[view] = paths_.emission();
    anyLight |= !boxes[view].empty() || maxComponent(emission[view]) > 0.0f;
    // A view that no light reaches is stored as such: a view that is not stored would be left out of the
    // interpolation.
    if (boxes[view].empty()) boxes[view].push_back({0, 0, 1, 1, Rgb(0.0f)});
  }
  if (!anyLight) return;
  matchSlots(sphere_, origin.normal, boxes, int(kernels.slots));
  result.glossy.resize(boxes.size());
  for (uint32_t view = 0; view < boxes.size(); ++view)
    if (stored[view]) result.glossy[view] = {pack(boxes[view], kernels.slots), emission[view]};
}

void TexelBaker::bakeSplit(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result) {
  const std::vector<bool> stored = viewsOfHemisphere(sphere_, origin.normal);
  result.glossy.resize(sphere_.viewCount());
  for (uint32_t view = 0; view < sphere_.viewCount(); ++view) {
    if (!stored[view]) continue;
    traceView(origin, view, kernels, result);
    if (!(paths_.hidden > 0.0)) continue;
    paths_.removeMirrored();
    RecordKernel& kernel = result.glossy[view];
    kernel.slots = pack(fit(glossyFitter_, kernels.slots - 1), kernels.slots - 1);
    kernel.slots.insert(kernel.slots.begin(), packHiddenPart(paths_.hiddenPart()));
    kernel.emission = paths_.emission();
  }
  key_.stream = kernels.firstStream + kMapStream;
  result.visibility = traceVisibility(world_, origin, key_);
}

PathOrigin TexelBaker::start(const RecordPlan& plan) {
  key_.texel = plan.record.atlasY * map_.width + plan.record.atlasX;
  return plan.origin(world_, map_);
}

const KernelPaths& TexelBaker::retrace(const RecordPlan& plan, std::optional<uint32_t> view) {
  const PathOrigin origin = start(plan);
  RecordKernels known;
  if (!view) {
    traceLambert(origin, known);
    return paths_;
  }
  traceView(origin, *view, {streamsOf(origin), options_.glossyPaths(plan.glossyLobes), 0}, known);
  if (plan.isSplit()) paths_.removeMirrored();
  return paths_;
}

RecordKernels TexelBaker::bake(const RecordPlan& plan, uint32_t glossySlots) {
  const PathOrigin origin = start(plan);
  RecordKernels result;
  if (plan.lambert) bakeLambert(origin, result);
  if (!plan.glossy) return result;
  const GlossyKernels kernels{streamsOf(origin), options_.glossyPaths(plan.glossyLobes), glossySlots};
  if (plan.isSplit())
    bakeSplit(origin, kernels, result);
  else
    bakeWhole(origin, kernels, result);
  return result;
}

}  // namespace boxlight
