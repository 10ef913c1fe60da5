// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_bake.h"

#include <tbb/global_control.h>

#include <memory>

#include "bake/commands/bake_options.h"
#include "bake/kernels/scene_bake.h"
#include "bake/scene/atlas.h"
#include "bake/scene/atlas_levels.h"
#include "bake/scene/gltf_load.h"
#include "bake/study/kernel_drawing.h"
#include "bake/study/kernel_report.h"
#include "common/asset/asset_writer.h"
#include "common/base/error.h"
#include "common/base/file.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

using Json = nlohmann::ordered_json;

bool viewsByRoughness(const BakeOptions& options) { return options.views == "auto"; }

/// Of records without coarse views.
uint32_t viewsOf(const BakeOptions& options) {
  return viewsByRoughness(options) ? 92 : uint32_t(std::stoul(options.views));
}

uint32_t frequencyOf(uint32_t views) {
  uint32_t frequency = 1;
  while (10 * frequency * frequency + 2 < views) ++frequency;
  return frequency;
}

/// Everything that the bytes of the asset depend on, and nothing else: no time, no host, no threads.
Json provenance(const BakeOptions& o, const Scene& scene) {
  Json document = {
      {"tool", "ptbake " BOXLIGHT_VERSION},
      {"scene", {{"file", scene.path.filename().string()}, {"xxh64", fmt::format("{:016x}", scene.hash)}}},
      {"options",
       {{"scheme", o.scheme},
        {"atlas", o.atlas},
        {"atlasUv", o.atlasUv},
        {"levels", o.levels},
        {"views", viewsByRoughness(o) ? Json("auto") : Json(viewsOf(o))},
        {"boxes", o.boxes},
        {"paths", o.paths},
        {"bounces", o.transport.bounces},
        {"ggx", o.transport.ggx},
        {"firefly_limit", o.transport.fireflyLimit}}},
      {"seed", o.transport.seed}};
  if (o.cells) document["options"]["cells"] = *o.cells;
  return document;
}

void announce(const BakeCost& cost) {
  const auto mebibytes = [](uint64_t bytes) { return double(bytes) / (1 << 20); };
  const std::string maps =
      cost.mapBytes ? fmt::format(", visibility maps {:.1f} MiB", mebibytes(cost.mapBytes)) : "";
  log().info("{} texel records, {} kernels, {:.1f} million paths; boxes take {:.1f} MiB{} before compression",
             cost.records, cost.kernels, double(cost.paths) * 1e-6, mebibytes(cost.pageBytes), maps);
}

void addLevels(const Scene& scene, TexelMap& map, uint32_t levels) {
  if (const std::string reason = addCoarserLevels(scene, map, levels); !reason.empty())
    log().warn("{}: {} of {} levels of the atlas: {}", scene.path.string(), 1 + map.coarser.size(), levels,
               reason);
}

/// Prints and draws one kernel.
void study(const KernelStudy& found, const BakeOptions& options, const CommonOptions& common) {
  fmt::print("{}", common.json ? kernelToJson(found).dump(2) + "\n" : kernelToText(found));
  writeTextFile(options.output, drawKernel(found));
}

void bake(BakeOptions options, const CommonOptions& common) {
  finishBakeOptions(options);
  checkOutput(options.output, {options.scene});
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    size_t(resolveThreads(common.threads)));
  Scene scene = loadGltf(options.scene);
  options.transport.applyTo(scene);
  const ProgressStyle progress = common.quiet ? ProgressStyle::none : common.progress;
  const AtlasReport atlas = chooseAtlas(scene, {options.atlas, atlasSources().at(options.atlasUv), progress});
  TexelMap map = makeTexels(scene, options.atlas, options.atlas);
  if (options.texel.empty()) addLevels(scene, map, options.levels);
  const Intersector world(scene);
  const std::vector<RecordPlan> records =
      planRecords(world, map, schemes().at(options.scheme), viewsByRoughness(options));
  const ViewSphere sphere(frequencyOf(viewsOf(options)));
  KernelOptions kernels{options.paths,
                        options.boxes,
                        {options.transport.bounceLimit(), options.transport.energyLimit()},
                        options.transport.seed};
  if (options.cells) kernels.cellFrequency = frequencyOf(*options.cells);
  if (!options.texel.empty()) {
    const KernelQuery query{{options.texel[0], options.texel[1]}, options.side == "back", options.view};
    return study(studyKernel(world, map, records, sphere, kernels, query), options, common);
  }
  log().info("{}: {} triangles, atlas {}x{} {}", options.scene, scene.triangles.size(), options.atlas,
             options.atlas, atlas.summary());
  announce(estimateCost(records, sphere, kernels));

  BakedScene baked = bakeScene(world, map, records, sphere, kernels, progress);
  options.transport.reportRemoved(baked.removed);
  baked.asset.provenance = provenance(options, scene);
  const size_t tileCount = baked.asset.tiles.size();
  asset::writeAsset(options.output, baked.asset, [&](uint32_t stream, uint32_t tile) {
    throwIfInterrupted("interrupted: no asset was written; run the same command again");
    return std::span<const PackedBox>(baked.pages[stream * tileCount + tile]);
  });
}

}  // namespace

void addBakeCommand(CLI::App& app, CommonOptions& common) {
  auto o = std::make_shared<BakeOptions>();
  CLI::App* command = app.add_subcommand("bake", "Bake a scene's light transport into an asset");
  addCommonOptions(*command, common);
  addBakeOptions(*command, *o);
  command->callback([o, &common] { bake(*o, common); });
}

}  // namespace boxlight
