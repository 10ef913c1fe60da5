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
    : map_(map),
      sphere_(sphere),
      options_(options),
      tracer_(world, options.bounces),
      lambertFitter_(FitOptions{.boxes = int(options.lambertBoxes()), .gridSize = 64}),
      glossyFitter_(FitOptions{.boxes = int(options.boxes)}) {
  key_.seed = options.seed;
}

std::vector<Box> TexelBaker::lambertBoxes(const PathOrigin& origin, uint32_t stream) {
  deposits_.clear();
  key_.stream = stream;
  const uint32_t traced = tracer_.traceLambert(origin, key_, options_.lambertPaths(), deposits_);
  return traced ? lambertFitter_.fit(deposits_, traced) : std::vector<Box>{};
}

std::vector<Box> TexelBaker::glossyBoxes(const PathOrigin& origin, uint32_t stream, vec3 wo) {
  deposits_.clear();
  key_.stream = stream;
  const uint32_t traced =
      tracer_.traceGlossy(origin, raiseAboveHorizon(wo, origin.normal), key_, options_.paths, deposits_);
  return traced ? glossyFitter_.fit(deposits_, traced) : std::vector<Box>{};
}

RecordKernels TexelBaker::bake(const RecordPlan& plan) {
  const PathOrigin origin = plan.origin(map_);
  const uint32_t side = origin.back ? kBackStreams : 0u;
  key_.texel = plan.record.atlasY * map_.width + plan.record.atlasX;
  RecordKernels result;
  if (plan.lambert)
    if (const auto boxes = lambertBoxes(origin, side + sphere_.viewCount()); !boxes.empty())
      result.lambert = pack(boxes, options_.lambertBoxes());
  if (!plan.glossy) return result;

  const std::vector<bool> stored = viewsOfHemisphere(sphere_, origin.normal);
  std::vector<std::vector<Box>> kernels(sphere_.viewCount());
  bool anyLight = false;
  for (uint32_t view = 0; view < sphere_.viewCount(); ++view) {
    if (!stored[view]) continue;
    kernels[view] = glossyBoxes(origin, side + view, sphere_.directions()[view]);
    anyLight |= !kernels[view].empty();
    // A view that no light reaches is stored as such: a view that is not stored would be left out of the
    // interpolation.
    if (kernels[view].empty()) kernels[view].push_back({0, 0, 1, 1, Rgb(0.0f)});
  }
  if (!anyLight) return result;
  matchSlots(sphere_, origin.normal, kernels, int(options_.boxes));
  result.glossy.resize(kernels.size());
  for (uint32_t view = 0; view < kernels.size(); ++view)
    if (stored[view]) result.glossy[view] = pack(kernels[view], options_.boxes);
  return result;
}

}  // namespace boxlight
