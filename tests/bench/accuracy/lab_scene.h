// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "bake/kernels/texel_records.h"
#include "common/light/view_sphere.h"
#include "tests/bench/accuracy/relative_error.h"

namespace boxlight::accuracy {

/// What is measured apart: the Lambert kernel, and glossy ones of GGX alpha .15 to .5 and .01 to .1.
enum class Gloss { diffuse, rough, sharp };
const char* nameOf(Gloss gloss);

/// A texel whose kernels are measured, and directions that it is seen from.
struct Subject {
  RecordPlan plan;
  std::vector<uint32_t> views;  ///< stored views
  std::vector<vec3> between;    ///< directions inside view triangles; none for Gloss::diffuse
  /// Mean over triangles of how the visible part of the lobe varies between corners.
  double occlusionChange = 0;
  vec3 normal() const { return {plan.record.normal[0], plan.record.normal[1], plan.record.normal[2]}; }
};

struct SubjectOptions {
  uint32_t texels = 32, viewsEach = 3;
  uint64_t seed = 1;
  float alpha = 0;  ///< of all texels picked; 0: any of the class
};

/// A scene ready to be traced.
class LabScene {
 public:
  explicit LabScene(const std::filesystem::path& file, uint32_t atlas = 128);

  const std::string& name() const { return name_; }
  const Intersector& world() const { return *world_; }
  const TexelMap& map() const { return map_; }
  const ViewSphere& sphere() const { return sphere_; }

  /// Texels drawn at random, each from all of its class: of glossy ones, out of four times as many, those
  /// whose occlusion changes most between views.
  std::vector<Subject> pick(Gloss gloss, const SubjectOptions& options) const;

  /// Paths of a subject's kernel; `view` has no meaning for Gloss::diffuse. Streams tell sets of paths apart.
  void trace(const Subject& subject, Gloss gloss, vec3 view, uint32_t stream, uint32_t paths,
             KernelPaths& result) const;
  /// From two halves of `paths`.
  Reference reference(const Subject& subject, Gloss gloss, vec3 view, uint32_t paths,
                      const std::vector<ProbeLight>& lights) const;

 private:
  double visiblePart(const PathOrigin& origin, vec3 view, const StreamKey& key) const;
  void pickViews(Subject& subject, const SubjectOptions& options, uint64_t seed) const;

  std::string name_;
  Scene scene_;
  TexelMap map_;
  std::unique_ptr<Intersector> world_;
  ViewSphere sphere_{3};
  std::vector<RecordPlan> records_;
};

/// What the deposits themselves return, with no kernel fitted to them.
Radiances relightDeposits(const KernelPaths& paths, const std::vector<ProbeLight>& lights);

}  // namespace boxlight::accuracy
