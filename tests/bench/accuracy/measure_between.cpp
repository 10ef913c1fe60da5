// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "bake/kernels/scene_bake.h"
#include "common/light/light_domain.h"
#include "common/light/lobe_boxes.h"
#include "common/light/relight.h"
#include "tests/bench/accuracy/split_scheme.h"
#include "tests/bench/accuracy/tally.h"

namespace boxlight::accuracy {
namespace {

constexpr float kFar = 1e4f;  ///< metres: where the eye stands, so that its direction is the texel's

/// The subjects' kernels for all views, baked as any scene's are.
struct Baked {
  uint32_t boxes;
  BakedScene scene;

  Relighter relighter() const {
    return Relighter(scene.asset, [this](uint32_t stream, uint32_t tile) {
      return scene.pages[stream * scene.asset.tiles.size() + tile];
    });
  }
};

Baked bake(const LabScene& scene, const std::vector<Subject>& subjects, uint32_t boxes, uint32_t paths) {
  std::vector<RecordPlan> plans;
  for (const Subject& subject : subjects) plans.push_back(subject.plan);
  for (RecordPlan& plan : plans) plan.lambert = false;
  return {boxes, bakeScene(scene.world(), scene.map(), plans, scene.sphere(), {paths, boxes, {}, 3},
                           ProgressStyle::none)};
}

class Schemes {
 public:
  Schemes(const LabScene& scene, const Baked& baked, const std::vector<ProbeLight>& lights, Row about)
      : sphere_(scene.sphere()),
        baked_(baked),
        relighter_(baked.relighter()),
        lights_(lights),
        about_(about) {
    about_.terms = baked.boxes;
    about_.bytes = baked.boxes * kBytesOfBox;
  }

  void tryAll(uint32_t record, vec3 direction, Sample& sample) {
    add("sketch", interpolated(record, direction, Interpolation::energy), sample);
    add("sketch, literal weights", interpolated(record, direction, Interpolation::weight), sample);
    add("three views blended", blended(record, direction), sample);
    add("mirror", mirrored(record, direction), sample);
  }

 private:
  void add(const char* method, Radiances value, Sample& sample) const {
    Row row = about_;
    row.method = method;
    sample.trials.push_back({row, std::move(value)});
  }

  vec3 eye(uint32_t record, vec3 direction) const {
    const auto& p = baked_.scene.asset.records[record].position;
    return vec3(p[0], p[1], p[2]) + kFar * direction;
  }

  Radiances interpolated(uint32_t record, vec3 direction, Interpolation interpolation) {
    Radiances value;
    for (const ProbeLight& light : lights_)
      value.push_back(
          relighter_.relight(record, eye(record, direction), light.area, 0, interpolation).glossy);
    return value;
  }

  Radiances blended(uint32_t record, vec3 direction) {
    Radiances value(lights_.size(), dvec3(0.0));
    const ViewBlend blend = sphere_.locate(direction);
    for (int k = 0; k < 3; ++k) {
      const Radiances corner =
          interpolated(record, sphere_.directions()[blend.view[k]], Interpolation::energy);
      for (size_t l = 0; l < value.size(); ++l) value[l] += double(blend.weight[k]) * corner[l];
    }
    return value;
  }

  /// The boxes of each of the three views, moved as far as the mirror direction moves from that view to this
  /// one, relit and blended.
  Radiances mirrored(uint32_t record, vec3 direction) {
    Radiances value(lights_.size(), dvec3(0.0));
    const auto& n = baked_.scene.asset.records[record].normal;
    const vec3 normal(n[0], n[1], n[2]);
    const auto mirrorOf = [&](vec3 view) {
      return directionToUv(glm::reflect(-raiseAboveHorizon(view, normal), normal));
    };
    const ViewBlend blend = sphere_.locate(direction);
    for (int k = 0; k < 3; ++k) {
      const vec2 moved = mirrorOf(direction) - mirrorOf(sphere_.directions()[blend.view[k]]);
      for (const PackedBox& packed : relighter_.kernel(blend.view[k], record)) {
        Rectangle place = rectangleOf(unpackBox(packed));
        place.u0 += double(moved.x) - std::floor(place.u0 + double(moved.x));
        place.v0 = std::clamp(place.v0 + double(moved.y), 0.0, 1.0 - place.dv);
        const dvec3 energy = double(blend.weight[k]) * dvec3(unpackBox(packed).energy);
        for (size_t l = 0; l < value.size(); ++l)
          value[l] += energy * lights_[l].area.integrate(place) / place.solidAngle();
      }
    }
    return value;
  }

  const ViewSphere& sphere_;
  const Baked& baked_;
  Relighter relighter_;
  const std::vector<ProbeLight>& lights_;
  Row about_;
};

constexpr uint32_t kDefaultCells = 6;  ///< of ptbake bake

/// What no interpolation can beat: the paths of that very direction, and a fit to them.
void tryDirect(const KernelPaths& paths, const std::vector<ProbeLight>& lights, Row about, Sample& sample) {
  about.method = "deposits";
  sample.trials.push_back({about, relightDeposits(paths, lights)});
  const Basis boxes = boxBasis(lights, 8);
  about.method = "direct fit", about.terms = boxes.terms, about.bytes = boxes.bytes;
  sample.trials.push_back({about, boxes.relight(paths, {})});
}

/// With as many boxes for what is hidden as a bake has, and with others.
void trySplit(SplitTexel& texel, const MeasureOptions& options, Row about, Sample& sample) {
  about.terms = kLobeBoxes;
  const auto add = [&](std::string method, Radiances radiances) {
    about.method = std::move(method);
    sample.trials.push_back({about, std::move(radiances)});
  };
  const uint32_t usual = texel.usualFrequency();
  add("split", texel.byViews(KernelOptions{}.hiddenBoxes(false), usual));
  for (const uint32_t boxes : {1u, 2u, 4u})
    add(fmt::format("split, {} hidden", boxes), texel.byViews(boxes, usual));
  for (const uint32_t frequency : options.views)
    add(fmt::format("split, {} views", ViewSphere(frequency).viewCount()),
        texel.byViews(KernelOptions{}.hiddenBoxes(false), frequency));
  for (const uint32_t frequency : options.cells)
    add(fmt::format("cells, {} directions", 10 * frequency * frequency + 2),
        texel.byCells(frequency, KernelOptions{}.hiddenBoxes(true)));
}

}  // namespace

std::vector<Row> measureBetween(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options) {
  const std::vector<Subject> subjects = scene.pick(gloss, options.subjects);
  std::vector<Sample> samples;
  std::vector<std::pair<uint32_t, vec3>> tasks;
  for (uint32_t s = 0; s < subjects.size(); ++s)
    for (const vec3 direction : subjects[s].between) tasks.emplace_back(s, direction);
  samples.resize(tasks.size());
  const Row about{.scene = scene.name(), .gloss = gloss, .place = "between", .paths = options.paths};
  tbb::parallel_for(size_t(0), tasks.size(), [&](size_t i) {
    const auto& [subject, direction] = tasks[i];
    samples[i].reference =
        scene.reference(subjects[subject], gloss, direction, options.referencePaths, lights);
    KernelPaths paths;
    scene.trace(subjects[subject], gloss, direction, 0x40000u + uint32_t(i), options.paths, paths);
    tryDirect(paths, lights, about, samples[i]);
    SplitTexel texel(scene, subjects[subject], direction, lights, options.paths);
    trySplit(texel, options, about, samples[i]);
  });
  for (const uint32_t boxes : options.boxes) {
    const Baked baked = bake(scene, subjects, boxes, options.paths);
    Schemes schemes(scene, baked, lights, about);
    for (size_t i = 0; i < tasks.size(); ++i) schemes.tryAll(tasks[i].first, tasks[i].second, samples[i]);
  }
  return tally(samples, lights);
}

std::vector<Row> measureAlpha(const LabScene& scene, float alpha, const std::vector<ProbeLight>& lights,
                              const MeasureOptions& options) {
  MeasureOptions own = options;
  own.subjects.alpha = alpha;
  own.boxes.clear();
  own.cells = {kDefaultCells};
  std::vector<Row> rows = measureBetween(scene, alpha < 0.12f ? Gloss::sharp : Gloss::rough, lights, own);
  for (Row& row : rows) row.place = fmt::format("between, alpha {:.2f}", alpha);
  return rows;
}

}  // namespace boxlight::accuracy
