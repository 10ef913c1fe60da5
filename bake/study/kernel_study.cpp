// SPDX-License-Identifier: Apache-2.0
#include "bake/study/kernel_study.h"

#include "bake/kernels/scene_bake.h"
#include "common/base/error.h"

namespace boxlight {
namespace {

bool isBack(const RecordPlan& plan) { return (plan.record.flags & asset::kBackSide) != 0; }

const char* sideName(bool back) { return back ? "back" : "front"; }

uint32_t findRecord(const TexelMap& map, const std::vector<RecordPlan>& records, const KernelQuery& query) {
  const auto [x, y] = std::pair(query.texel.x, query.texel.y);
  if (x >= map.width || y >= map.height)
    fail(ExitCode::usage, "--texel {},{}: the atlas has {}x{} texels", x, y, map.width, map.height);
  const uint32_t nearest = map.nearest[size_t(y) * map.width + x];
  if (nearest == asset::kNone) fail(ExitCode::usage, "--texel {},{}: no surface is near that texel", x, y);
  const Texel& covered = map.texels[nearest];
  if (covered.x != x || covered.y != y)
    fail(ExitCode::usage, "--texel {},{} is in the gutter; it shows texel {},{}", x, y, covered.x, covered.y);
  for (uint32_t r = 0; r < records.size(); ++r)
    if (records[r].record.level == 0 && records[r].texel == nearest && isBack(records[r]) == query.back)
      return r;
  fail(ExitCode::usage, "--texel {},{}: its {} is never seen", x, y, sideName(query.back));
}

[[noreturn]] void failBelow(const KernelQuery& query) {
  fail(ExitCode::usage, "--view {} lies below the horizon of texel {},{}", *query.view, query.texel.x,
       query.texel.y);
}

/// `sphere`: of the directions that the texel's glossy kernels are for.
void requireKernel(const KernelStudy& study, const ViewSphere& sphere) {
  const auto& [texel, back, view] = study.query;
  if (!view) {
    if (!study.plan.lambert)
      fail(ExitCode::usage,
           "--texel {},{} has no Lambert kernel: nothing of its material is diffuse; give a --view", texel.x,
           texel.y);
    return;
  }
  if (*view >= sphere.viewCount())
    fail(ExitCode::usage, "--view {}: there are {} {}", *view, sphere.viewCount(),
         study.plan.hasCells() ? "direction cells" : "views");
  if (!study.plan.glossy)
    fail(ExitCode::usage, "--texel {},{} has no glossy kernels: leave out --view for its Lambert kernel",
         texel.x, texel.y);
  const auto& n = study.plan.record.normal;
  if (!study.plan.hasCells() && !viewsOfHemisphere(sphere, {n[0], n[1], n[2]})[*view]) failBelow(study.query);
}

void keepSlots(const RecordKernel& kernel, KernelStudy& study) {
  study.emission = kernel.emission;
  for (const PackedBox& slot : kernel.slots)
    if (isHiddenPart(slot))
      study.hiddenPart = unpackHiddenPart(slot);
    else if (isCosineBox(slot))
      study.cosineBoxes.push_back(unpackCosineBox(slot));
    else if (const Box box = unpackBox(slot); maxComponent(box.energy) > 0.0f)
      study.boxes.push_back(box);
}

}  // namespace

KernelStudy studyKernel(const Intersector& world, const TexelMap& map, const std::vector<RecordPlan>& records,
                        const ViewSphere& sphere, const KernelOptions& options, const KernelQuery& query) {
  KernelStudy study;
  study.query = query;
  study.record = findRecord(map, records, query);
  study.plan = records[study.record];
  const ViewSphere directions = study.plan.hasCells() ? ViewSphere(options.cellFrequency)
                                                      : viewSpheres(sphere)[study.plan.viewSphere()];
  requireKernel(study, directions);
  TexelBaker baker(world, map, sphere, options);
  const RecordKernels kernels = baker.bake(study.plan, glossySlotsOf(records, study.record, options));
  const auto& n = study.plan.record.normal;
  if (query.view) {
    const vec3 direction = directions.directions()[*query.view];
    study.viewDirection =
        study.plan.hasCells() ? direction : raiseAboveHorizon(direction, {n[0], n[1], n[2]});
    if (study.plan.isSplit()) study.hiddenPart = 0.0f;
    const auto& glossy = study.plan.hasCells() ? kernels.cells : kernels.glossy;
    if (!glossy.empty()) keepSlots(glossy[*query.view], study);
  } else {
    keepSlots(kernels.lambert, study);
  }
  study.visibility = kernels.visibility;
  const KernelPaths& paths = baker.retrace(study.plan, query.view);
  if (study.plan.hasCells() && query.view && paths.traced == 0) failBelow(query);
  study.deposits = paths.deposits;
  study.traced = paths.traced;
  return study;
}

}  // namespace boxlight
