// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <set>

#include "runtime/app/keys.h"
#include "runtime/app/truth_render.h"
#include "runtime/app/view_options.h"
#include "runtime/app/viewer.h"
#include "runtime/app/window.h"

namespace boxlight::gpu {

/// What keys, mouse, dropped files and the panel's buttons do to a session, and what goes on by itself:
/// flight, recordings, the truth being rendered. What fails after the start leaves a message and everything
/// as it was.
class Controller {
 public:
  /// Opens what the options name. Errors: those of the readers and of the device.
  Controller(const ViewOptions& options, Window& window, Viewer& viewer);

  void handle(const WindowEvent& event);
  void act(Action action);
  void open(const std::filesystem::path& path);  ///< an asset or a light
  /// Before each frame: the picture becomes `size` pixels, `seconds` have passed since the last.
  void advance(uvec2 size, float seconds);

  Session& session() { return session_; }
  bool isBusy() const { return recording_ || session_.flying; }  ///< does time alone change the picture?
  uint32_t splitColumn(uvec2 size) const;  ///< where the truth begins; past all without one
  std::string progress() const;            ///< of what goes on by itself; or empty

 private:
  void openFirst();
  void loadTruth();
  void drag(const MouseDrag& drag);
  void actOnFiles(Action action);
  bool guarded(const std::function<void()>& action);
  void flyHeld(float seconds);
  void toggleTruth();
  void pollTruth();
  void screenshot();
  void startRecording(const char* stem, std::vector<CameraOptions> cameras);
  void recordFrame();
  bool holdsSplit() const;

  const ViewOptions& options_;
  Window& window_;
  Viewer& viewer_;
  Session session_;
  std::optional<TruthRender> truthRender_;
  std::optional<Recording> recording_;
  bool dragging_ = false, draggingSplit_ = false;
  std::set<int> flyKeys_;  // pressed to fly
};

}  // namespace boxlight::gpu
