// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/accuracy/lab_scene.h"

#include <algorithm>

#include "bake/scene/atlas.h"
#include "bake/scene/gltf_load.h"
#include "tests/support/kernel_lab.h"

namespace boxlight::accuracy {
namespace {

constexpr float kLeastCosine = 0.1f;   ///< of a measured view above the texel's horizon
constexpr uint32_t kProbePaths = 256;  ///< that estimate how much of a lobe is visible
constexpr float kSameAlpha = 0.05f;
constexpr uint32_t kCandidates = 4;  ///< for each subject that is taken
constexpr uint32_t kFirstHalf = 0x20000u, kProbeStream = 0x30000u;

float alphaOf(const RecordPlan& plan) { return plan.record.roughness * plan.record.roughness; }

bool isOf(const RecordPlan& plan, Gloss gloss) {
  if (gloss == Gloss::diffuse) return plan.lambert;
  const float alpha = alphaOf(plan);
  if (!plan.glossy || plan.glossyLobes != 1) return false;
  return gloss == Gloss::rough ? alpha > 0.149f && alpha < 0.501f : alpha > 0.009f && alpha < 0.101f;
}

}  // namespace

const char* nameOf(Gloss gloss) {
  return gloss == Gloss::diffuse ? "diffuse" : gloss == Gloss::rough ? "rough" : "sharp";
}

LabScene::LabScene(const std::filesystem::path& file, uint32_t atlas)
    : name_(file.stem().string()), scene_(loadGltf(file)) {
  chooseAtlas(scene_, {.size = atlas});
  map_ = makeTexels(scene_, atlas, atlas);
  world_ = std::make_unique<Intersector>(scene_);
  records_ = planRecords(*world_, map_);
}

double LabScene::visiblePart(const PathOrigin& origin, vec3 view, const StreamKey& key) const {
  KernelPaths direct;
  PathTracer(*world_, {.bounces = 1}).traceGlossy(origin, view, key, kProbePaths, direct);
  return direct.traced ? double(direct.deposits.size()) / direct.traced : 0.0;
}

/// Random view triangles whose corners are all above the horizon; of each its first corner and a direction
/// inside.
void LabScene::pickViews(Subject& subject, const SubjectOptions& options, uint64_t seed) const {
  lab::Random random(seed);
  const vec3 normal = subject.normal();
  const PathOrigin origin = subject.plan.origin(*world_, map_);
  for (uint32_t tries = 0; subject.views.size() < options.viewsEach && tries < 1000; ++tries) {
    const uvec3 corners = sphere_.triangles()[size_t(random.uniform() * float(sphere_.triangles().size()))];
    const auto direction = [&](int k) { return sphere_.directions()[corners[k]]; };
    if (std::min({dot(direction(0), normal), dot(direction(1), normal), dot(direction(2), normal)}) <
        kLeastCosine)
      continue;
    vec2 b(random.uniform(), random.uniform());
    if (b.x + b.y > 1) b = 1.0f - b;
    subject.views.push_back(corners[0]);
    subject.between.push_back(
        glm::normalize((1 - b.x - b.y) * direction(0) + b.x * direction(1) + b.y * direction(2)));
    double least = 1, most = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      const double part = visiblePart(origin, direction(int(k)), {seed, tries, kProbeStream + k});
      least = std::min(least, part), most = std::max(most, part);
    }
    subject.occlusionChange += (most - least) / options.viewsEach;
  }
}

std::vector<Subject> LabScene::pick(Gloss gloss, const SubjectOptions& options) const {
  std::vector<Subject> candidates;
  std::vector<uint32_t> members;
  for (uint32_t r = 0; r < records_.size(); ++r)
    if (isOf(records_[r], gloss) &&
        (options.alpha == 0 || std::abs(alphaOf(records_[r]) - options.alpha) < kSameAlpha * options.alpha))
      members.push_back(r);
  const uint32_t wanted = gloss == Gloss::diffuse ? options.texels : kCandidates * options.texels;
  lab::Random random(options.seed);
  for (uint32_t i = 0; i < wanted && !members.empty(); ++i) {
    const auto member = size_t(random.uniform() * float(members.size()));
    candidates.push_back({records_[members[member]], {}, {}, 0});
    members[member] = members.back();
    members.pop_back();
    if (gloss == Gloss::diffuse)
      candidates.back().views = {0};
    else
      pickViews(candidates.back(), options, options.seed + i);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Subject& a, const Subject& b) { return a.occlusionChange > b.occlusionChange; });
  if (candidates.size() > options.texels) candidates.resize(options.texels);
  return candidates;
}

void LabScene::trace(const Subject& subject, Gloss gloss, vec3 view, uint32_t stream, uint32_t paths,
                     KernelPaths& result) const {
  const PathTracer tracer(*world_, {});
  const PathOrigin origin = subject.plan.origin(*world_, map_);
  const StreamKey key{7, subject.plan.record.atlasY * map_.width + subject.plan.record.atlasX, stream};
  if (gloss == Gloss::diffuse)
    tracer.traceLambert(origin, key, paths, result);
  else
    tracer.traceGlossy(origin, raiseAboveHorizon(view, origin.normal), key, paths, result);
}

Reference LabScene::reference(const Subject& subject, Gloss gloss, vec3 view, uint32_t paths,
                              const std::vector<ProbeLight>& lights) const {
  Radiances half[2];
  for (uint32_t k = 0; k < 2; ++k) {
    KernelPaths traced;
    trace(subject, gloss, view, kFirstHalf + k, paths / 2, traced);
    half[k] = relightDeposits(traced, lights);
  }
  Reference reference;
  for (size_t l = 0; l < lights.size(); ++l) {
    const dvec3 difference = half[0][l] - half[1][l];
    reference.mean.push_back(0.5 * (half[0][l] + half[1][l]));
    reference.variance.push_back(0.25 * difference * difference);
  }
  return reference;
}

Radiances relightDeposits(const KernelPaths& paths, const std::vector<ProbeLight>& lights) {
  Radiances sum(lights.size(), dvec3(0.0));
  for (const Deposit& deposit : paths.deposits)
    for (size_t l = 0; l < lights.size(); ++l) {
      const Image& map = lights[l].map;
      const uint32_t x = std::min(uint32_t(deposit.uv.x * float(map.width)), map.width - 1);
      const uint32_t y = std::min(uint32_t(deposit.uv.y * float(map.height)), map.height - 1);
      sum[l] += dvec3(deposit.throughput * rgbAt(map, x, y));
    }
  for (dvec3& radiance : sum) radiance = paths.traced ? radiance / double(paths.traced) : dvec3(0.0);
  return sum;
}

}  // namespace boxlight::accuracy
