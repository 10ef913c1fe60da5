// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/bench/accuracy/basis.h"
#include "tests/bench/accuracy/lab_scene.h"

namespace boxlight::accuracy {

/// One figure of the tables.
struct Row {
  std::string scene;
  Gloss gloss;
  std::string place;   ///< "views", "between" them, or "between, alpha A"
  std::string method;  ///< a basis, a scheme, or "deposits": the floor of the paths themselves
  uint32_t terms, bytes, paths;
  double soft, sunLit;  ///< RelativeError
  double
      milliseconds;  ///< of one core for a kernel: fitting and relighting under all lights; 0 if not measured
  uint32_t samples;
};

struct MeasureOptions {
  SubjectOptions subjects;
  uint32_t referencePaths = 1 << 17, cleanPaths = 1 << 15, paths = 1024;
  std::vector<uint32_t> boxes{1, 2, 4, 8, 16, 32, 64};
  std::vector<float> alphas{0.02f, 0.1f, 0.3f};  ///< that are measured apart
  std::vector<uint32_t> cells{3, 4, 6, 8};       ///< frequencies of their sphere
  std::vector<uint32_t> views{1, 2, 3, 4, 6};    ///< of view spheres
};

/// Kernels as they are at the views themselves.
std::vector<Row> measureAtViews(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options);

/// Of texels of one GGX alpha: what a direct fit and the schemes split and cells make of them between the
/// views.
std::vector<Row> measureAlpha(const LabScene& scene, float alpha, const std::vector<ProbeLight>& lights,
                              const MeasureOptions& options);

/// What the schemes make of the 92 views' kernels in between, and what a fit at that very direction would.
std::vector<Row> measureBetween(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options);

}  // namespace boxlight::accuracy
