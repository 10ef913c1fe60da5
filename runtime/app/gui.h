// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>

#include "runtime/app/keys.h"
#include "runtime/app/viewer.h"

namespace boxlight::gpu {

/// The last pictures' GPU times by pass, for the plot.
class PassHistory {
 public:
  static constexpr size_t kLength = 120;
  void add(const std::vector<PassTime>& times);
  struct Row {
    std::string pass;
    std::deque<float> milliseconds;  ///< oldest first, kLength at most; 0 where the pass did not run
  };
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

/// What the interface is told beside the session.
struct GuiState {
  const Viewer& viewer;
  const PassHistory& history;
  const std::string& device;
  std::string progress;  ///< of a recording or of a truth; empty without one
};

/// Panel, help, dialogue and the split's line. Changes the session's settings; what keys do too, it asks for
/// by `act`; a typed path goes to `open`.
class Gui {
 public:
  /// Makes Dear ImGui's context, with text for a screen of `scale`.
  explicit Gui(float scale);
  ~Gui();
  void draw(Session& session, const GuiState& state, const std::function<void(Action)>& act,
            const std::function<void(const std::string&)>& open);

 private:
  void drawPanel(Session& session, const GuiState& state, const std::function<void(Action)>& act);
  void drawDialog(Session& session, const std::function<void(const std::string&)>& open);

  float scale_;
  std::string path_;
};

}  // namespace boxlight::gpu
