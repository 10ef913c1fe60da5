// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/bake_options.h"

#include <filesystem>

#include "common/base/error.h"

namespace boxlight {
namespace {

constexpr uint32_t kDefaultCells = 362;

struct Preset {
  uint32_t atlas, boxes, paths;
};

const std::map<std::string, Preset>& presets() {
  static const std::map<std::string, Preset> table = {
      {"draft", {64, 8, 128}}, {"preview", {128, 8, 256}}, {"production", {256, 8, 256}}};
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

void checkStudy(const BakeOptions& o) {
  const bool isDrawing = std::filesystem::path(o.output).extension() == ".svg";
  if (o.texel.empty() && (o.view || o.side != "front"))
    fail(ExitCode::usage, "--view and --side say which kernel of a --texel to look at; give one");
  if (!o.texel.empty() && !isDrawing)
    fail(ExitCode::usage, "'{}': --texel draws one kernel; the name of its drawing must end in .svg",
         o.output);
}

}  // namespace

const std::map<std::string, AtlasSource>& atlasSources() {
  static const std::map<std::string, AtlasSource> table = {{"auto", AtlasSource::automatic},
                                                           {"chart", AtlasSource::chart},
                                                           {"0", AtlasSource::texcoord0},
                                                           {"1", AtlasSource::texcoord1}};
  return table;
}

const std::map<std::string, asset::Scheme>& schemes() {
  // The split beats the sketch at every roughness that was measured (docs/decisions/006-split-lobes.md);
  // cells are sharper where mirrors show surfaces, and take more bytes and time (008-direction-cells.md).
  static const std::map<std::string, asset::Scheme> table = {{"auto", asset::Scheme::split},
                                                             {"sketch", asset::Scheme::sketch},
                                                             {"split", asset::Scheme::split},
                                                             {"cells", asset::Scheme::cells}};
  return table;
}

void finishBakeOptions(BakeOptions& options) {
  applyPreset(options);
  if (options.cells && options.scheme != "cells")
    fail(ExitCode::usage, "--cells {}: the scheme {} has none; give --scheme cells", *options.cells,
         options.scheme);
  if (options.scheme == "cells" && !options.cells) options.cells = kDefaultCells;
  checkStudy(options);
}

void addBakeOptions(CLI::App& command, BakeOptions& options) {
  command.add_option("scene", options.scene, "glTF 2.0 scene, .glb or .gltf")
      ->required()
      ->option_text("SCENE");
  command.add_option("-o,--output", options.output, "Asset to write; of --texel the drawing, .svg")
      ->required()
      ->option_text("OUT.ptb");
  command.add_option("--preset", options.preset, presetHelp())
      ->check(CLI::IsMember({"draft", "preview", "production"}))
      ->capture_default_str();
  command.add_option("--atlas", options.atlas, "Texels per side of the atlas")
      ->check(CLI::Range(1, 8192))
      ->option_text("N");
  command
      .add_option("--levels", options.levels,
                  "Of the atlas, itself included: coarser ones for pictures in which the object is small, as "
                  "far as charts stay apart")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  command
      .add_option("--atlas-uv", options.atlasUv,
                  "Where the atlas comes from: TEXCOORD_0 or _1, charts of our own, or what fits")
      ->check(CLI::IsMember({"auto", "chart", "0", "1"}))
      ->capture_default_str();
  command
      .add_option("--scheme", options.scheme,
                  "sketch: boxes are all there is to gloss. split: pixels shade their own reflection of the "
                  "light, boxes hold what other surfaces send, sheen and transmission. cells: split, and "
                  "mirrors show other surfaces more sharply, at more bytes. auto: split")
      ->check(CLI::IsMember({"auto", "sketch", "split", "cells"}))
      ->capture_default_str();
  command
      .add_option(
          "--views", options.views,
          "View directions of all gloss. auto: 92, but 42 or 12 where pixels shade all lobes themselves and "
          "these are rough")
      ->check(CLI::IsMember({"auto", "12", "42", "92", "162", "252", "362"}))
      ->capture_default_str();
  command
      .add_option("--cells", options.cells,
                  "Of the scheme cells: directions that light comes from: 42, 92, 162, 252, 362 or 642")
      ->check(CLI::IsMember({42, 92, 162, 252, 362, 642}))
      ->option_text(fmt::format("N [{}]", kDefaultCells));
  command
      .add_option("--boxes", options.boxes,
                  "Boxes per glossy kernel; the Lambert kernel has four times as many, up to 64")
      ->check(CLI::Range(1, 64))
      ->option_text("J");
  command
      .add_option("--paths", options.paths,
                  "Paths per glossy kernel; the Lambert kernel has 64 times as many")
      ->check(CLI::Range(1, 1 << 24))
      ->option_text("N");
  command
      .add_option("--texel", options.texel,
                  "Bake nothing: print the kernel of this texel as it would be baked, and draw it as SVG")
      ->delimiter(',')
      ->expected(2)
      ->option_text("X,Y");
  command
      .add_option("--view", options.view,
                  "Of --texel: its kernel for this view, or direction cell if it has those; without it, the "
                  "Lambert kernel")
      ->option_text("N");
  command.add_option("--side", options.side, "Of --texel")
      ->check(CLI::IsMember({"front", "back"}))
      ->capture_default_str();
  addTransportOptions(command, options.transport,
                      "Largest throughput of a path; more is removed and reported. 0 = no limit");
}

}  // namespace boxlight
