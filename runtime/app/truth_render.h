// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "runtime/app/session.h"

namespace boxlight::gpu {

/// `ptbake render` of what the window shows, in a process of its own with the lowest priority.
class TruthRender {
 public:
  /// Starts it. `scene` is the glTF scene that the asset was baked from. Error: ExitCode::io if ptbake is
  /// neither beside this program nor on the PATH.
  TruthRender(const std::filesystem::path& scene, const SettingsFile& file);
  ~TruthRender();  ///< ends the process and removes its file
  TruthRender(const TruthRender&) = delete;
  TruthRender& operator=(const TruthRender&) = delete;

  /// The truth once it is there. Error: ExitCode::runtime if ptbake failed; what it said is on stderr.
  std::optional<Truth> poll();

 private:
  SettingsFile file_;
  std::filesystem::path output_;
  int process_ = -1;
};

}  // namespace boxlight::gpu
