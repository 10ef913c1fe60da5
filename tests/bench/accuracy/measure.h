// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/bench/accuracy/basis.h"
#include "tests/bench/accuracy/lab_scene.h"

namespace boxlight::accuracy {

/// One figure of the tables.
struct Row {
  std::string scene;
  Gloss gloss;
  std::string place;   ///< "views", or "between" them
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
  bool splitAlone = false;  ///< between the views, of all schemes
};

/// Kernels as they are at the views themselves.
std::vector<Row> measureAtViews(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options);

/// What the schemes make of the 92 views' kernels in between, and what a fit at that very direction would.
std::vector<Row> measureBetween(const LabScene& scene, Gloss gloss, const std::vector<ProbeLight>& lights,
                                const MeasureOptions& options);

}  // namespace boxlight::accuracy
