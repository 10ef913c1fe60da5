// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/atlas.h"

#include "bake/scene/bleeding.h"
#include "bake/scene/uv_set.h"
#include "common/base/error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

void takeUvSet(Scene& scene, uint32_t set) {
  for (asset::Vertex& vertex : scene.vertices)
    for (int k = 0; k < 2; ++k) vertex.atlasUv[k] = std::clamp(vertex.uv[set][k], 0.0f, 1.0f);
}

/// Takes the set if it can be the atlas; else says why not.
std::string tryUvSet(Scene& scene, uint32_t set, AtlasReport& report, uint32_t size) {
  if (std::string fault = inspectUvSet(scene, set).fault(); !fault.empty()) return fault;
  takeUvSet(scene, set);
  report.uvSet = set;
  report.density = measureDensity(scene, size);
  return {};
}

void warnOfUnusedScales(const Scene& scene, uint32_t set) {
  if (scene.texelScales.empty()) return;
  log().warn("{}: boxlight_texel_scale has no effect: the atlas is TEXCOORD_{}; take --atlas-uv chart",
             scene.path.string(), set);
}

AtlasReport takeAsked(Scene& scene, uint32_t set, uint32_t size) {
  AtlasReport report;
  const std::string fault = tryUvSet(scene, set, report, size);
  if (fault.empty()) return report;
  fail(ExitCode::unsupported, "{}: TEXCOORD_{} cannot be the atlas: it {}; take --atlas-uv chart or auto",
       scene.path.string(), set, fault);
}

/// Why the automatic source passes over a set that was taken and could be the atlas; empty if it does not.
std::string inspectTaken(const Scene& scene, const TexelDensity& density, uint32_t size) {
  if (density.mean > kMostStarved * density.least)
    return fmt::format("gives part of the surface {:.3g} texels a metre, {:.3g} in the mean", density.least,
                       density.mean);
  if (const double bleeding = measureBleeding(scene, size); bleeding > kMostBleeding)
    return fmt::format("lets its charts bleed into each other by {:.1f} % in an atlas of {}", 100 * bleeding,
                       size);
  return {};
}

/// The first good UV set, or kNone and why there is none.
AtlasReport takeFirstGood(Scene& scene, uint32_t size) {
  AtlasReport report;
  for (uint32_t set = 0; set < 2; ++set) {
    std::string fault = tryUvSet(scene, set, report, size);
    if (fault.empty()) fault = inspectTaken(scene, report.density, size);
    if (fault.empty()) return {.uvSet = set, .density = report.density};
    report.reason += fmt::format("{}TEXCOORD_{} {}", set ? "; " : "", set, fault);
  }
  report.uvSet = asset::kNone;
  return report;
}

}  // namespace

AtlasReport chooseAtlas(Scene& scene, const AtlasOptions& options) {
  AtlasReport report;
  if (options.source == AtlasSource::automatic) report = takeFirstGood(scene, options.size);
  if (options.source == AtlasSource::texcoord0) report = takeAsked(scene, 0, options.size);
  if (options.source == AtlasSource::texcoord1) report = takeAsked(scene, 1, options.size);
  if (report.uvSet != asset::kNone) {
    warnOfUnusedScales(scene, report.uvSet);
    return report;
  }
  report.charting = chartScene(scene, options.size, options.progress);
  report.density = measureDensity(scene, options.size);
  return report;
}

std::string AtlasReport::summary() const {
  std::string text = uvSet != asset::kNone ? fmt::format("from TEXCOORD_{}", uvSet)
                                           : fmt::format("of {} charts", charting.charts);
  if (charting.shared) text += fmt::format(" ({} share texels)", charting.shared);
  if (charting.gutter) text += fmt::format(", gutters of {} texels", charting.gutter);
  text += fmt::format(", {:.0f} % covered, {:.3g} texels a metre ({:.3g} to {:.3g})", 100 * density.coverage,
                      density.mean, density.least, density.most);
  return reason.empty() ? text : fmt::format("{} ({})", text, reason);
}

}  // namespace boxlight
