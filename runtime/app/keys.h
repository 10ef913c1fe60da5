// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

namespace boxlight::gpu {

/// What a key or the mouse does in the window.
enum class Action {
  none,  // a row of the table for the mouse
  toggleFly,
  flyForward,
  flyBack,
  flyLeft,
  flyRight,
  flyUp,
  flyDown,
  fit,
  reset,
  help,
  panel,
  brighter,
  darker,
  nextToneMap,
  background,
  moreBoxes,
  fewerBoxes,
  open,
  truth,
  screenshot,
  saveSettings,
  turntable,
  addPathCamera,
  clearPath,
  recordPath,
  cancel,
  quit,
};

/// When a row of the table holds.
enum class KeyMode { always, orbiting, flying };

struct KeyBinding {
  const char* keys;  ///< as people write them
  const char* what;
  KeyMode mode = KeyMode::always;
  Action action = Action::none;
  int key = 0;         ///< GLFW_KEY_..., 0 for the mouse
  bool shift = false;  ///< must be held; else must not be, but for keys that are held down to fly
  bool control = false;
};

/// Every key of the window: the program, its help, and docs/ptview.md take them from here.
std::span<const KeyBinding> keyTable();

/// Of a key press. Nothing while the key means nothing in this mode.
std::optional<Action> actionOf(int key, bool shift, bool control, bool flying);

/// Is this action's key held down to move, rather than pressed once?
bool isHeld(Action action);

/// The table as Markdown, as docs/ptview.md has it; and as aligned text.
std::string keysAsMarkdown();
std::string keysAsText();

}  // namespace boxlight::gpu
