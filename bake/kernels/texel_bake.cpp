// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/texel_bake.h"

#include "bake/kernels/box_match.h"
#include "bake/kernels/visibility_trace.h"
#include "common/light/ggx.h"

namespace boxlight {
namespace {

constexpr uint32_t kBackStreams = 0x10000u;  ///< added to a stream's number on the back side of a texel
constexpr uint32_t kMapStream = 0x8000u;     ///< apart from every view's
constexpr uint32_t kCellStreams = 0x4000u;   ///< from here on those of direction cells

/// The first of an origin's streams of random numbers.
uint32_t streamsOf(const PathOrigin& origin) { return origin.back ? kBackStreams : 0u; }

std::vector<PackedBox> pack(const std::vector<Box>& boxes, size_t count) {
  std::vector<PackedBox> packed(count);
  for (size_t j = 0; j < boxes.size(); ++j) packed[j] = packBox(boxes[j]);
  return packed;
}

}  // namespace

std::vector<ViewSphere> viewSpheres(const ViewSphere& sphere) {
  std::vector<ViewSphere> spheres{sphere};
  for (const CoarseViews& coarse : kViewsByRoughness) spheres.emplace_back(coarse.frequency);
  return spheres;
}

TexelBaker::TexelBaker(const Intersector& world, const TexelMap& map, const ViewSphere& sphere,
                       const KernelOptions& options)
    : world_(world),
      map_(map),
      spheres_(viewSpheres(sphere)),
      cells_(options.cellFrequency),
      options_(options),
      tracer_(world, options.limits),
      straightFitter_(straightFit(options.lambertBoxes())),
      fitter_(FitOptions{.boxes = int(KernelOptions::kMaxFittedBoxes)}) {
  key_.seed = options.seed;
}

void TexelBaker::account(RecordKernels& result) const {
  for (const Deposit& deposit : paths_.deposits) result.energy += double(luminance(deposit.throughput));
  result.removed += paths_.removed;
}

std::vector<Box> TexelBaker::fit(uint32_t boxes) {
  return paths_.traced && boxes > 0 ? fitter_.fit(paths_.deposits, paths_.traced, int(boxes))
                                    : std::vector<Box>{};
}

void TexelBaker::traceLambert(const PathOrigin& origin, RecordKernels& result) {
  paths_.clear();
  key_.stream = streamsOf(origin) + spheres_[0].viewCount();
  tracer_.traceLambert(origin, key_, options_.lambertPaths(), paths_);
  account(result);
}

void TexelBaker::bakeLambert(const PathOrigin& origin, RecordKernels& result) {
  traceLambert(origin, result);
  std::vector<PackedBox> slots;
  for (CosineBox box : straightFitter_.fit(paths_.first, origin.normal)) {
    box.amplitude *= std::min(options_.limits.throughput, 1.0f);  // of deposits that it scales down, too
    slots.push_back(packCosineBox(box));
  }
  paths_.removeStraight();
  for (const Box& box : fit(options_.lambertBoxes() - uint32_t(slots.size()))) slots.push_back(packBox(box));
  result.lambert.emission = paths_.emission();
  if (slots.empty() && !(maxComponent(result.lambert.emission) > 0.0f)) return;
  slots.resize(options_.lambertBoxes());
  result.lambert.slots = std::move(slots);
}

void TexelBaker::traceView(const PathOrigin& origin, uint32_t view, const GlossyKernels& kernels,
                           RecordKernels& result) {
  paths_.clear();
  key_.stream = kernels.firstStream + view;
  const vec3 wo = raiseAboveHorizon(kernels.sphere.directions()[view], origin.normal);
  tracer_.traceGlossy(origin, wo, key_, kernels.paths, paths_);
  account(result);
}

void TexelBaker::bakeWhole(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result) {
  const std::vector<bool> stored = viewsOfHemisphere(kernels.sphere, origin.normal);
  std::vector<std::vector<Box>> boxes(kernels.sphere.viewCount());
  std::vector<Rgb> emission(kernels.sphere.viewCount(), Rgb(0.0f));
  bool anyLight = false;
  for (uint32_t view = 0; view < kernels.sphere.viewCount(); ++view) {
    if (!stored[view]) continue;
    traceView(origin, view, kernels, result);
    boxes[view] = fit(kernels.slots);
    emission[view] = paths_.emission();
    anyLight |= !boxes[view].empty() || maxComponent(emission[view]) > 0.0f;
    // A view that no light reaches is stored as such: a view that is not stored would be left out of the
    // interpolation.
    if (boxes[view].empty()) boxes[view].push_back({0, 0, 1, 1, Rgb(0.0f)});
  }
  if (!anyLight) return;
  matchSlots(kernels.sphere, origin.normal, boxes, int(kernels.slots));
  result.glossy.resize(boxes.size());
  for (uint32_t view = 0; view < boxes.size(); ++view)
    if (stored[view]) result.glossy[view] = {pack(boxes[view], kernels.slots), emission[view]};
}

void TexelBaker::bakeSplit(const PathOrigin& origin, const GlossyKernels& kernels, RecordKernels& result) {
  const std::vector<bool> stored = viewsOfHemisphere(kernels.sphere, origin.normal);
  result.glossy.resize(kernels.sphere.viewCount());
  for (uint32_t view = 0; view < kernels.sphere.viewCount(); ++view) {
    if (!stored[view]) continue;
    traceView(origin, view, kernels, result);
    const bool isDark = !(maxComponent(paths_.emission()) > 0.0f);
    if (isDark && paths_.hiddenPart() <
                      KernelOptions::leastHiddenPart(kernels.sphere.frequency() < spheres_[0].frequency()))
      continue;
    paths_.removeMirrored();
    result.glossy[view] = hiddenKernel(kernels.slots);
  }
}

void TexelBaker::traceCell(const RecordPlan& plan, const PathOrigin& origin, uint32_t cell,
                           const GlossyKernels& kernels, RecordKernels& result) {
  paths_.clear();
  key_.stream = kernels.firstStream + kCellStreams + cell;
  const DirectionCell directions{cells_.directions()[cell], 1.0f - 2.0f / float(cells_.viewCount()),
                                 ggx::alphaOf(plan.record.roughness)};
  tracer_.traceIncident(origin, directions, key_, kernels.paths, paths_);
  account(result);
}

void TexelBaker::bakeCells(const RecordPlan& plan, const PathOrigin& origin, const GlossyKernels& kernels,
                           RecordKernels& result) {
  result.cells.resize(cells_.viewCount());
  for (uint32_t cell = 0; cell < cells_.viewCount(); ++cell) {
    traceCell(plan, origin, cell, kernels, result);
    if (paths_.hidden > 0.0) result.cells[cell] = hiddenKernel(kernels.slots);
  }
}

/// Of the paths at hand, which hold no light that pixels reflect themselves.
RecordKernel TexelBaker::hiddenKernel(uint32_t slots) {
  RecordKernel kernel{pack(fit(slots - 1), slots - 1), paths_.emission()};
  kernel.slots.insert(kernel.slots.begin(), packHiddenPart(paths_.hiddenPart()));
  return kernel;
}

PathOrigin TexelBaker::start(const RecordPlan& plan) {
  const uint32_t level = plan.record.level;
  key_.texel = streamTexel(level, plan.record.atlasY * map_.level(level).width + plan.record.atlasX);
  return plan.origin(world_, map_);
}

const KernelPaths& TexelBaker::retrace(const RecordPlan& plan, std::optional<uint32_t> view) {
  const PathOrigin origin = start(plan);
  RecordKernels known;
  if (!view) {
    traceLambert(origin, known);
    return paths_;
  }
  const GlossyKernels kernels{spheres_[plan.viewSphere()], streamsOf(origin),
                              options_.glossyPaths(plan.glossyLobes), 0};
  if (plan.hasCells())
    traceCell(plan, origin, *view, kernels, known);
  else
    traceView(origin, *view, kernels, known);
  if (plan.isSplit()) paths_.removeMirrored();
  return paths_;
}

RecordKernels TexelBaker::bake(const RecordPlan& plan, uint32_t glossySlots) {
  const PathOrigin origin = start(plan);
  RecordKernels result;
  if (plan.lambert) bakeLambert(origin, result);
  if (!plan.glossy) return result;
  const GlossyKernels kernels{spheres_[plan.viewSphere()], streamsOf(origin),
                              options_.glossyPaths(plan.glossyLobes), glossySlots};
  if (!plan.isSplit()) {
    bakeWhole(origin, kernels, result);
    return result;
  }
  if (plan.hasCells())
    bakeCells(plan, origin, kernels, result);
  else
    bakeSplit(origin, kernels, result);
  key_.stream = kernels.firstStream + kMapStream;
  result.visibility = traceVisibility(world_, origin, key_);
  return result;
}

}  // namespace boxlight
