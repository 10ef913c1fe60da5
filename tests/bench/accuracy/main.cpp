// SPDX-License-Identifier: Apache-2.0
// accuracy SCENE.glb... --light IMAGE... -o OUT.json: how far representations and schemes are from the
// transport that they stand for. scripts/accuracy runs it and writes docs/accuracy.md.
#include <tbb/global_control.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "common/base/cli.h"
#include "common/base/error.h"
#include "common/base/log.h"
#include "tests/bench/accuracy/measure.h"

namespace {

using namespace boxlight;
using namespace boxlight::accuracy;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> scenes, lights;
  std::string output, place = "both";
  MeasureOptions measure;
  ProbeOptions probe;
};

Json toJson(const Row& row) {
  return {{"scene", row.scene},    {"class", nameOf(row.gloss)}, {"place", row.place},
          {"method", row.method},  {"terms", row.terms},         {"bytes", row.bytes},
          {"paths", row.paths},    {"samples", row.samples},     {"soft", row.soft},
          {"sun_lit", row.sunLit}, {"ms", row.milliseconds}};
}

void append(Json& rows, const std::vector<Row>& found) {
  for (const Row& row : found) rows.push_back(toJson(row));
  if (!found.empty())
    log().info("{}: {} {}, {} samples", found[0].scene, nameOf(found[0].gloss), found[0].place,
               found[0].samples);
}

void run(const Options& options) {
  const std::vector<ProbeLight> lights =
      makeProbeLights({options.lights.begin(), options.lights.end()}, options.probe);
  Json result{{"lights", Json::array()}, {"rows", Json::array()}};
  for (size_t l = 0; l < lights.size(); l += options.probe.rotations)
    result["lights"].push_back({{"name", lights[l].name}, {"sun_lit", lights[l].sunLit}});
  for (const std::string& file : options.scenes) {
    const LabScene scene(file);
    for (const Gloss gloss : {Gloss::diffuse, Gloss::rough, Gloss::sharp}) {
      if (options.place != "between")
        append(result["rows"], measureAtViews(scene, gloss, lights, options.measure));
      if (options.place != "views" && gloss != Gloss::diffuse)
        append(result["rows"], measureBetween(scene, gloss, lights, options.measure));
    }
    if (options.place == "views") continue;
    for (const float alpha : options.measure.alphas)
      append(result["rows"], measureAlpha(scene, alpha, lights, options.measure));
  }
  std::ofstream out(options.output);
  out << result.dump(1) << '\n';
  if (!out.flush()) fail(ExitCode::io, "{}: cannot be written", options.output);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How far kernels are from the transport that they stand for");
  CommonOptions common;
  Options options;
  addCommonOptions(app, common);
  app.add_option("scenes", options.scenes, "glTF scenes")->required();
  app.add_option("--light", options.lights, "Environment images")->required();
  app.add_option("-o,--output", options.output, "JSON to write")->required();
  app.add_option("--place", options.place, "Where to measure")
      ->check(CLI::IsMember({"both", "views", "between"}))
      ->capture_default_str();
  app.add_option("--texels", options.measure.subjects.texels, "Texels of every class")->capture_default_str();
  app.add_option("--boxes", options.measure.boxes, "Boxes of a kernel")->capture_default_str();
  app.add_option("--alphas", options.measure.alphas, "GGX alphas that are measured apart")
      ->capture_default_str();
  app.add_option("--paths", options.measure.paths, "of the kernels")->capture_default_str();
  app.add_option("--reference-paths", options.measure.referencePaths)->capture_default_str();
  app.add_option("--clean-paths", options.measure.cleanPaths)->capture_default_str();
  app.add_option("--rotations", options.probe.rotations, "of every image")->capture_default_str();
  app.add_option("--light-size", options.probe.size.x, "Columns of the lights")->capture_default_str();
  return runMain(app, argc, argv, common, [&] {
    options.probe.size.y = options.probe.size.x / 2;
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      size_t(resolveThreads(common.threads)));
    run(options);
  });
}
