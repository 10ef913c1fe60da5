// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_bake.h"

#include <tbb/global_control.h>

#include <map>
#include <memory>

#include "bake/commands/transport_options.h"
#include "bake/kernels/scene_bake.h"
#include "bake/scene/atlas.h"
#include "bake/scene/gltf_load.h"
#include "common/asset/asset_writer.h"
#include "common/base/error.h"
#include "common/base/file.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

struct BakeOptions {
  std::string scene, output, preset = "preview", atlasUv = "auto", scheme = "auto";
  TransportOptions transport;
  uint32_t atlas = 0, views = 92, boxes = 0, paths = 0;  ///< 0: as the preset says
};

struct Preset {
  uint32_t atlas, boxes, paths;
};

const std::map<std::string, Preset>& presets() {
  static const std::map<std::string, Preset> table = {
      {"draft", {64, 8, 128}}, {"preview", {128, 8, 256}}, {"production", {256, 8, 256}}};
  return table;
}

const std::map<std::string, AtlasSource>& atlasSources() {
  static const std::map<std::string, AtlasSource> table = {{"auto", AtlasSource::automatic},
                                                           {"chart", AtlasSource::chart},
                                                           {"0", AtlasSource::texcoord0},
                                                           {"1", AtlasSource::texcoord1}};
  return table;
}

const std::map<std::string, asset::Scheme>& schemes() {
  // The split is the most accurate at every roughness that was measured (docs/decisions/006-split-lobes.md).
  static const std::map<std::string, asset::Scheme> table = {
      {"auto", asset::Scheme::split}, {"sketch", asset::Scheme::sketch}, {"split", asset::Scheme::split}};
  return table;
}

std::string presetHelp() {
  std::string help = "Atlas size, boxes and paths of ";
  for (const auto& [name, preset] : presets())
    help += fmt::format("{}{}: {}, {}, {}", name == presets().begin()->first ? "" : "; ", name, preset.atlas,
                        preset.boxes, preset.paths);
  return help;
}

void applyPreset(BakeOptions& options) {
  const Preset& preset = presets().at(options.preset);
  if (!options.atlas) options.atlas = preset.atlas;
  if (!options.boxes) options.boxes = preset.boxes;
  if (!options.paths) options.paths = preset.paths;
}

uint32_t frequencyOf(uint32_t views) {
  uint32_t frequency = 1;
  while (10 * frequency * frequency + 2 < views) ++frequency;
  return frequency;
}

/// Everything that the bytes of the asset depend on, and nothing else: no time, no host, no threads.
nlohmann::ordered_json provenance(const BakeOptions& o, const Scene& scene) {
  return {
      {"tool", "ptbake " BOXLIGHT_VERSION},
      {"scene", {{"file", scene.path.filename().string()}, {"xxh64", fmt::format("{:016x}", scene.hash)}}},
      {"options",
       {{"scheme", o.scheme},
        {"atlas", o.atlas},
        {"atlasUv", o.atlasUv},
        {"views", o.views},
        {"boxes", o.boxes},
        {"paths", o.paths},
        {"bounces", o.transport.bounces},
        {"ggx", o.transport.ggx},
        {"firefly_limit", o.transport.fireflyLimit}}},
      {"seed", o.transport.seed}};
}

void announce(const BakeCost& cost) {
  const auto mebibytes = [](uint64_t bytes) { return double(bytes) / (1 << 20); };
  const std::string maps =
      cost.mapBytes ? fmt::format(", visibility maps {:.1f} MiB", mebibytes(cost.mapBytes)) : "";
  log().info("{} texel records, {} kernels, {:.1f} million paths; boxes take {:.1f} MiB{} before compression",
             cost.records, cost.kernels, double(cost.paths) * 1e-6, mebibytes(cost.pageBytes), maps);
}

void bake(BakeOptions options, const CommonOptions& common) {
  applyPreset(options);
  checkOutput(options.output, {options.scene});
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    size_t(resolveThreads(common.threads)));
  Scene scene = loadGltf(options.scene);
  options.transport.applyTo(scene);
  const ProgressStyle progress = common.quiet ? ProgressStyle::none : common.progress;
  const AtlasReport atlas = chooseAtlas(scene, {options.atlas, atlasSources().at(options.atlasUv), progress});
  const TexelMap map = makeTexels(scene, options.atlas, options.atlas);
  const Intersector world(scene);
  const std::vector<RecordPlan> records = planRecords(world, map, schemes().at(options.scheme));
  const ViewSphere sphere(frequencyOf(options.views));
  const KernelOptions kernels{options.paths,
                              options.boxes,
                              {options.transport.bounceLimit(), options.transport.energyLimit()},
                              options.transport.seed};
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
  command->add_option("scene", o->scene, "glTF 2.0 scene, .glb or .gltf")->required()->option_text("SCENE");
  command->add_option("-o,--output", o->output, "Asset to write")->required()->option_text("OUT.ptb");
  command->add_option("--preset", o->preset, presetHelp())
      ->check(CLI::IsMember({"draft", "preview", "production"}))
      ->capture_default_str();
  command->add_option("--atlas", o->atlas, "Texels per side of the atlas")
      ->check(CLI::Range(1, 8192))
      ->option_text("N");
  command
      ->add_option("--atlas-uv", o->atlasUv,
                   "Where the atlas comes from: TEXCOORD_0 or _1, charts of our own, or what fits")
      ->check(CLI::IsMember({"auto", "chart", "0", "1"}))
      ->capture_default_str();
  command
      ->add_option("--scheme", o->scheme,
                   "sketch: boxes are all there is to gloss. split: pixels shade their own reflection of the "
                   "light, boxes hold what other surfaces send, sheen and transmission. auto: the most "
                   "accurate, which is split")
      ->check(CLI::IsMember({"auto", "sketch", "split"}))
      ->capture_default_str();
  command->add_option("--views", o->views, "View directions")
      ->check(CLI::IsMember({12, 42, 92, 162, 252, 362}))
      ->capture_default_str();
  command
      ->add_option("--boxes", o->boxes,
                   "Boxes per glossy kernel; the Lambert kernel has four times as many, up to 64")
      ->check(CLI::Range(1, 64))
      ->option_text("J");
  command->add_option("--paths", o->paths, "Paths per glossy kernel; the Lambert kernel has 64 times as many")
      ->check(CLI::Range(1, 1 << 24))
      ->option_text("N");
  addTransportOptions(*command, o->transport,
                      "Largest throughput of a path; more is removed and reported. 0 = no limit");
  command->callback([o, &common] { bake(*o, common); });
}

}  // namespace boxlight
