// SPDX-License-Identifier: Apache-2.0
#include <tbb/parallel_for.h>

#include <chrono>

#include "tests/bench/accuracy/tally.h"

namespace boxlight::accuracy {
namespace {

void tryBasis(const Basis& basis, const KernelPaths& paths, vec3 normal, const Row& about, Sample& sample) {
  const auto start = std::chrono::steady_clock::now();
  Radiances value = basis.relight(paths, normal);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  Row row = about;
  row.method = basis.name, row.terms = basis.terms, row.bytes = basis.bytes, row.paths = paths.traced;
  row.milliseconds = took.count();
  sample.trials.push_back({row, std::move(value)});
}

constexpr uint32_t kLeastLambertBoxes = 4;  ///< that a bake has

Basis floorOf(const std::vector<ProbeLight>& lights) {
  return {"deposits", 0, 0,
          [&lights](const KernelPaths& paths, vec3) { return relightDeposits(paths, lights); }};
}

std::vector<Basis> basesOf(const std::vector<ProbeLight>& lights, Gloss gloss,
                           const MeasureOptions& options) {
  std::vector<Basis> bases{floorOf(lights)};
  for (const uint32_t boxes : options.boxes)
    bases.push_back(gloss == Gloss::diffuse && boxes >= kLeastLambertBoxes ? lambertBasis(lights, boxes)
                                                                           : boxBasis(lights, boxes));
  const auto haar = makeCubeHaar(lights);
  for (const uint32_t bands : {3, 4, 8}) bases.push_back(harmonicBasis(lights, bands));
  for (const uint32_t coefficients : {6, 12, 48}) bases.push_back(waveletBasis(haar, coefficients));
  for (const uint32_t gaussians : {4, 8, 32}) bases.push_back(gaussianBasis(lights, gaussians));
  return bases;
}

}  // namespace

std::vector<Row> measureAtViews(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options) {
  const std::vector<Subject> subjects = scene.pick(gloss, options.subjects);
  const std::vector<Basis> bases = basesOf(lights, gloss, options);
  std::vector<std::pair<size_t, uint32_t>> tasks;  // subject, view
  for (size_t s = 0; s < subjects.size(); ++s)
    for (const uint32_t view : subjects[s].views) tasks.emplace_back(s, view);
  std::vector<Sample> samples(tasks.size());
  Row about{.scene = scene.name(), .gloss = gloss, .place = "views"};
  tbb::parallel_for(size_t(0), tasks.size(), [&](size_t i) {
    const Subject& subject = subjects[tasks[i].first];
    const uint32_t view = tasks[i].second;
    const vec3 direction = scene.sphere().directions()[view];
    samples[i].reference = scene.reference(subject, gloss, direction, options.referencePaths, lights);
    for (const uint32_t count : {options.paths, options.cleanPaths}) {
      KernelPaths paths;
      scene.trace(subject, gloss, direction, view, count, paths);
      for (const Basis& basis : bases) tryBasis(basis, paths, subject.normal(), about, samples[i]);
    }
  });
  std::vector<Row> rows = tally(samples, lights);
  const size_t half = rows.size() / 2;  // what a kernel without light traced is not said by its first sample
  for (size_t t = 0; t < rows.size(); ++t) rows[t].paths = t < half ? options.paths : options.cleanPaths;
  return rows;
}

}  // namespace boxlight::accuracy
